#version 330 core
// One quad around a stroke. Pixels, y down.
layout(location = 0) in vec2 from;
layout(location = 1) in vec2 to;
layout(location = 2) in vec2 shape;  // half width, 1: round ends
layout(location = 3) in vec4 stroke;
uniform vec2 picture;
flat out vec2 f_middle;
flat out vec2 f_axis;
flat out vec3 f_shape;  // half length, half width, round
flat out vec4 f_color;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1 & 1) * 2.0 - 1.0;
  vec2 span = to - from;
  float reach = length(span);
  vec2 axis = reach > 0.0 ? span / reach : vec2(1.0, 0.0);
  vec2 local = corner * (vec2(0.5 * reach + shape.x * shape.y, shape.x) + 1.0);
  vec2 middle = 0.5 * (from + to);
  vec2 pixel = middle + local.x * axis + local.y * vec2(-axis.y, axis.x);
  gl_Position = vec4(2.0 * pixel.x / picture.x - 1.0, 2.0 * pixel.y / picture.y - 1.0, 0.0, 1.0);
  f_middle = middle;
  f_axis = axis;
  f_shape = vec3(0.5 * reach, shape);
  f_color = vec4(stroke.rgb * stroke.a, stroke.a);
}
