#version 330 core
// One quad around an arrow. Pixels, y down; the fragment shader's y is up.
layout(location = 0) in vec2 tail;
layout(location = 1) in vec2 tip;
layout(location = 2) in vec4 shape;  // half width, head length, head half width, grow
layout(location = 3) in vec4 stroke;
uniform vec2 picture;
flat out vec2 f_tail;
flat out vec2 f_axis;
flat out vec3 f_shaft;  // end of the shaft, its half width, both with half a pixel of coverage; half a pixel and growth
flat out vec3 f_slant;  // signed distance from the head's front edge: dot((u, v), xy) + z
flat out vec3 f_back;   // and from its swept-back edge
flat out vec4 f_color;

void main() {
  vec2 span = tip - tail;
  float reach = length(span);
  vec2 axis = span / max(reach, 1e-6);
  float wing = shape.z;
  float head = shape.y;
  float notch = 0.25 * head;
  float base = reach - head;
  float grow = shape.w;
  // The grown head's corners run ahead of the head by up to 3.2 times the growth.
  float margin = 3.5 * max(grow, 0.0) + 1.0;
  float side = max(shape.x, wing) + margin;
  vec2 local = vec2((gl_VertexID & 2) == 0 ? min(-margin, base - margin) : reach + margin, (gl_VertexID & 1) == 0 ? -side : side);
  vec2 pixel = tail + local.x * axis + local.y * vec2(-axis.y, axis.x);
  gl_Position = vec4(2.0 * pixel.x / picture.x - 1.0, 2.0 * pixel.y / picture.y - 1.0, 0.0, 1.0);
  f_tail = vec2(tail.x, picture.y - tail.y);
  f_axis = vec2(axis.x, -axis.y);
  f_shaft = vec3(base + notch, shape.x, 0.5 + grow);
  f_slant = vec3(wing, head, -reach * wing) / length(vec2(wing, head));
  f_back = vec3(-wing, -notch, (base + notch) * wing) / length(vec2(wing, notch));
  f_color = vec4(stroke.rgb * stroke.a, stroke.a);
}
