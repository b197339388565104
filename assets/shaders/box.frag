#version 330 core
// A filled rectangle with an outline inside and, if asked for, both diagonals. Premultiplied alpha.
flat in vec2 f_center;
flat in vec2 f_axis;
flat in vec4 f_reach;
flat in vec4 f_diagonal;
flat in vec4 f_fill;
flat in vec4 f_outline;
uniform vec2 picture;
out vec4 color;

void main() {
  vec2 p = vec2(gl_FragCoord.x, picture.y - gl_FragCoord.y) - f_center;
  vec2 q = abs(vec2(p.x * f_axis.x + p.y * f_axis.y, p.y * f_axis.x - p.x * f_axis.y));
  vec4 edges = clamp(f_reach - q.xyxy, 0.0, 1.0);
  float line = clamp(f_diagonal.z - abs(q.x * f_diagonal.x + q.y * f_diagonal.y), 0.0, 1.0);
  float covered = edges.x * edges.y;
  float filled = edges.z * edges.w * (1.0 - line * f_diagonal.w);
  color = f_outline * (covered - filled) + f_fill * filled;
}
