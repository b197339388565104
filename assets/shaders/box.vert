#version 330 core
// One quad per box, one pixel larger than the box on every side. Pixels, y down.
layout(location = 0) in vec2 center;
layout(location = 1) in vec2 axis;
layout(location = 2) in vec2 half_size;
layout(location = 3) in vec2 widths;  // outline, diagonals
layout(location = 4) in vec4 fill;
layout(location = 5) in vec4 outline;
uniform vec2 picture;
flat out vec2 f_center;
flat out vec2 f_axis;
flat out vec2 f_half_size;
flat out vec2 f_widths;
flat out vec4 f_fill;
flat out vec4 f_outline;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  vec2 local = corner * (half_size + 1.0);
  vec2 pixel = center + local.x * axis + local.y * vec2(-axis.y, axis.x);
  gl_Position = vec4(2.0 * pixel.x / picture.x - 1.0, 1.0 - 2.0 * pixel.y / picture.y, 0.0, 1.0);
  f_center = center;
  f_axis = axis;
  f_half_size = half_size;
  f_widths = widths;
  f_fill = vec4(fill.rgb * fill.a, fill.a);
  f_outline = vec4(outline.rgb * outline.a, outline.a);
}
