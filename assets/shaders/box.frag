#version 330 core
// A filled rectangle with an outline inside and, if asked for, both diagonals. Premultiplied alpha.
flat in vec2 f_center;
flat in vec2 f_axis;
flat in vec2 f_half_size;
flat in vec2 f_widths;
flat in vec4 f_fill;
flat in vec4 f_outline;
uniform vec2 picture;
out vec4 color;

// The length of [x - 1/2, x + 1/2] within [-h, h], x >= 0: coverage of a pixel by a strip.
vec2 overlap(vec2 x, vec2 h) { return clamp(min(x + 0.5, h) - max(x - 0.5, -h), 0.0, 1.0); }

void main() {
  vec2 p = vec2(gl_FragCoord.x, picture.y - gl_FragCoord.y) - f_center;
  vec2 q = abs(vec2(dot(p, f_axis), p.y * f_axis.x - p.x * f_axis.y));
  vec2 outer = overlap(q, f_half_size);
  vec2 inner = overlap(q, f_half_size - f_widths.x);
  float covered = outer.x * outer.y;
  float filled = inner.x * inner.y;
  if (f_widths.y > 0.0) {
    float distance = abs(q.x * f_half_size.y - q.y * f_half_size.x) / length(f_half_size);
    filled *= 1.0 - overlap(vec2(distance), vec2(0.5 * f_widths.y)).x;
  }
  color = f_outline * (covered - filled) + f_fill * filled;
}
