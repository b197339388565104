#version 330 core
// A stroke with round or square ends. Premultiplied alpha.
flat in vec2 f_middle;
flat in vec2 f_axis;
flat in vec3 f_shape;
flat in vec4 f_color;
out vec4 color;

float overlap(float x, float h) { return clamp(min(x + 0.5, h) - max(x - 0.5, -h), 0.0, 1.0); }

void main() {
  vec2 p = gl_FragCoord.xy - f_middle;
  vec2 q = abs(vec2(dot(p, f_axis), p.y * f_axis.x - p.x * f_axis.y));
  float rounded = overlap(length(vec2(max(q.x - f_shape.x, 0.0), q.y)), f_shape.y);
  float cut = overlap(q.x, f_shape.x) * overlap(q.y, f_shape.y);
  color = f_color * (f_shape.z > 0.5 ? rounded : cut);
}
