#version 330 core
// Shaft and swept-back head as one shape; u runs along the arrow, v >= 0 across. Premultiplied alpha.
flat in vec2 f_tail;
flat in vec2 f_axis;
flat in float f_length;
flat in vec4 f_shape;  // half width, head length, head half width, grow
flat in vec4 f_color;
uniform vec2 picture;
out vec4 color;

void main() {
  vec2 p = vec2(gl_FragCoord.x, picture.y - gl_FragCoord.y) - f_tail;
  float u = dot(p, f_axis);
  float v = abs(p.y * f_axis.x - p.x * f_axis.y);
  float head = f_shape.y;
  float wing = f_shape.z;
  float notch = 0.25 * head;
  float base = f_length - head;
  float shaft = max(max(-u, u - (base + notch)), v - f_shape.x);
  float slant = ((u - f_length) * wing + v * head) / length(vec2(wing, head));
  float back = (base + notch - notch * v / wing - u) * wing / length(vec2(wing, notch));
  float distance = min(shaft, max(slant, back)) - f_shape.w;
  color = f_color * clamp(0.5 - distance, 0.0, 1.0);
}
