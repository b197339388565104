#version 330 core
// A disc with an outline inside. Premultiplied alpha.
flat in vec2 f_center;
flat in vec2 f_shape;
flat in vec4 f_fill;
flat in vec4 f_outline;
out vec4 color;

void main() {
  float distance = length(gl_FragCoord.xy - f_center) - f_shape.x;
  float covered = clamp(0.5 - distance, 0.0, 1.0);
  float filled = clamp(0.5 - distance - f_shape.y, 0.0, 1.0);
  color = f_outline * (covered - filled) + f_fill * filled;
}
