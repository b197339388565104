#version 330 core
// One quad around an arrow. Pixels, y down.
layout(location = 0) in vec2 tail;
layout(location = 1) in vec2 tip;
layout(location = 2) in vec4 shape;  // half width, head length, head half width, grow
layout(location = 3) in vec4 stroke;
uniform vec2 picture;
flat out vec2 f_tail;
flat out vec2 f_axis;
flat out float f_length;
flat out vec4 f_shape;
flat out vec4 f_color;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 span = tip - tail;
  float reach = length(span);
  vec2 axis = span / max(reach, 1e-6);
  // The grown head's tip runs ahead of the tip itself by less than three times the growth.
  float margin = 3.0 * shape.w + 1.0;
  vec2 local = vec2(mix(-margin, reach + margin, corner.x),
                    mix(-1.0, 1.0, corner.y) * (max(shape.x, shape.z) + margin));
  vec2 pixel = tail + local.x * axis + local.y * vec2(-axis.y, axis.x);
  gl_Position = vec4(2.0 * pixel.x / picture.x - 1.0, 1.0 - 2.0 * pixel.y / picture.y, 0.0, 1.0);
  f_tail = tail;
  f_axis = axis;
  f_length = reach;
  f_shape = shape;
  f_color = vec4(stroke.rgb * stroke.a, stroke.a);
}
