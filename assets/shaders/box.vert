#version 330 core
// One quad per box, one pixel larger than the box on every side. Pixels, y down; the fragment shader's y is up.
layout(location = 0) in vec2 center;
layout(location = 1) in vec2 axis;
layout(location = 2) in vec2 half_size;
layout(location = 3) in vec2 widths;  // outline, diagonals
layout(location = 4) in vec4 fill;
layout(location = 5) in vec4 outline;
uniform vec2 picture;
flat out vec2 f_center;
flat out vec2 f_axis;
flat out vec4 f_reach;     // where coverage ends: outer edges, inner edges
flat out vec4 f_diagonal;  // normal of the diagonal in the first quadrant, where its coverage ends, its opacity
flat out vec4 f_fill;
flat out vec4 f_outline;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1 & 1) * 2.0 - 1.0;
  vec2 local = corner * (half_size + 1.0);
  vec2 pixel = center + local.x * axis + local.y * vec2(-axis.y, axis.x);
  gl_Position = vec4(2.0 * pixel.x / picture.x - 1.0, 2.0 * pixel.y / picture.y - 1.0, 0.0, 1.0);
  f_center = vec2(center.x, picture.y - center.y);
  f_axis = vec2(axis.x, -axis.y);
  // What is narrower than a pixel is drawn one pixel wide and fades, so that its ink stays right.
  vec2 drawn = max(half_size, 0.5);
  vec2 fade = min(2.0 * half_size, 1.0);
  f_reach = vec4(drawn, drawn - widths.x) + 0.5;
  f_diagonal = vec4(vec2(half_size.y, -half_size.x) / length(half_size), max(0.5 * widths.y, 0.5) + 0.5,
                    min(widths.y, 1.0));
  f_fill = vec4(fill.rgb * fill.a, fill.a) * fade.x * fade.y;
  f_outline = vec4(outline.rgb * outline.a, outline.a) * fade.x * fade.y;
}
