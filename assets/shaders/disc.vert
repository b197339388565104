#version 330 core
// One quad around a disc. Pixels, y down.
layout(location = 0) in vec2 center;
layout(location = 1) in vec2 shape;  // radius, outline width
layout(location = 2) in vec4 fill;
layout(location = 3) in vec4 outline;
uniform vec2 picture;
flat out vec2 f_center;
flat out vec2 f_shape;
flat out vec4 f_fill;
flat out vec4 f_outline;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1 & 1) * 2.0 - 1.0;
  vec2 pixel = center + corner * (shape.x + 1.0);
  gl_Position = vec4(2.0 * pixel.x / picture.x - 1.0, 2.0 * pixel.y / picture.y - 1.0, 0.0, 1.0);
  f_center = center;
  f_shape = shape;
  f_fill = vec4(fill.rgb * fill.a, fill.a);
  f_outline = vec4(outline.rgb * outline.a, outline.a);
}
