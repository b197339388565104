#version 330 core
// One quad around a triangle. Pixels, y down.
layout(location = 0) in vec2 a;
layout(location = 1) in vec2 b;
layout(location = 2) in vec2 c;
layout(location = 3) in float outline_width;
layout(location = 4) in vec4 fill;
layout(location = 5) in vec4 outline;
uniform vec2 picture;
flat out vec3 f_ab;  // the sides as lines: signed distance = dot(xy, p) + z, positive outside
flat out vec3 f_bc;
flat out vec3 f_ca;
flat out float f_outline_width;
flat out vec4 f_fill;
flat out vec4 f_outline;

vec3 line(vec2 from, vec2 to, float turn) {
  vec2 normal = turn * normalize(vec2(to.y - from.y, from.x - to.x));
  return vec3(normal, -dot(normal, from));
}

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1 & 1);
  vec2 low = min(a, min(b, c)) - 1.0;
  vec2 high = max(a, max(b, c)) + 1.0;
  vec2 pixel = mix(low, high, corner);
  gl_Position = vec4(2.0 * pixel.x / picture.x - 1.0, 2.0 * pixel.y / picture.y - 1.0, 0.0, 1.0);
  float turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0.0 ? 1.0 : -1.0;
  f_ab = line(a, b, turn);
  f_bc = line(b, c, turn);
  f_ca = line(c, a, turn);
  f_outline_width = outline_width;
  f_fill = vec4(fill.rgb * fill.a, fill.a);
  f_outline = vec4(outline.rgb * outline.a, outline.a);
}
