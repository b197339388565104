#version 330 core
// Shaft and swept-back head as one shape; u runs along the arrow, v >= 0 across. Premultiplied alpha.
flat in vec2 f_tail;
flat in vec2 f_axis;
flat in vec3 f_shaft;
flat in vec3 f_slant;
flat in vec3 f_back;
flat in vec4 f_color;
uniform vec2 picture;
out vec4 color;

void main() {
  vec2 p = vec2(gl_FragCoord.x, picture.y - gl_FragCoord.y) - f_tail;
  float u = p.x * f_axis.x + p.y * f_axis.y;
  float v = abs(p.y * f_axis.x - p.x * f_axis.y);
  float shaft = max(max(-u, u - f_shaft.x), v - f_shaft.y);
  float slant = u * f_slant.x + v * f_slant.y + f_slant.z;
  float back = u * f_back.x + v * f_back.y + f_back.z;
  color = f_color * clamp(f_shaft.z - min(shaft, max(slant, back)), 0.0, 1.0);
}
