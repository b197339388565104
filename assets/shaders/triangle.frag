#version 330 core
// A triangle with an outline inside. Premultiplied alpha.
flat in vec3 f_ab;
flat in vec3 f_bc;
flat in vec3 f_ca;
flat in float f_outline_width;
flat in vec4 f_fill;
flat in vec4 f_outline;
out vec4 color;

void main() {
  vec2 p = gl_FragCoord.xy;
  float distance = max(dot(f_ab.xy, p) + f_ab.z, max(dot(f_bc.xy, p) + f_bc.z, dot(f_ca.xy, p) + f_ca.z));
  float covered = clamp(0.5 - distance, 0.0, 1.0);
  float filled = clamp(0.5 - distance - f_outline_width, 0.0, 1.0);
  color = f_outline * (covered - filled) + f_fill * filled;
}
