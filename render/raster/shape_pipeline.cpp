#include "render/raster/shape_pipeline.h"

#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "render/error.h"
#include "render/raster/shader_source.h"

namespace wuerfel::internal {
namespace {

constexpr std::size_t vertices_of_quad = 4;
constexpr std::size_t indices_of_quad = 6;

/// One vertex attribute: `floats` floats, or a colour of four bytes.
struct Attribute {
  int floats = 0;  ///< 0: colour
  std::size_t offset = 0;
};

struct Layout {
  std::size_t shape = 0;  ///< bytes
  std::size_t stride = 0;
  std::span<const Attribute> attributes;
};

constexpr std::array box_attributes{
    Attribute{2, offsetof(BoxShape, center)},    Attribute{2, offsetof(BoxShape, axis)},
    Attribute{2, offsetof(BoxShape, half_size)}, Attribute{2, offsetof(BoxShape, outline_width)},
    Attribute{0, offsetof(BoxShape, fill)},      Attribute{0, offsetof(BoxShape, outline)}};
constexpr std::array segment_attributes{
    Attribute{2, offsetof(SegmentShape, from)}, Attribute{2, offsetof(SegmentShape, to)},
    Attribute{2, offsetof(SegmentShape, half_width)}, Attribute{0, offsetof(SegmentShape, color)}};
constexpr std::array arrow_attributes{
    Attribute{2, offsetof(ArrowShape, tail)}, Attribute{2, offsetof(ArrowShape, tip)},
    Attribute{4, offsetof(ArrowShape, half_width)}, Attribute{0, offsetof(ArrowShape, color)},
    Attribute{1, sizeof(ArrowShape)}};  // the part
constexpr std::array disc_attributes{
    Attribute{2, offsetof(DiscShape, center)}, Attribute{2, offsetof(DiscShape, radius)},
    Attribute{0, offsetof(DiscShape, fill)}, Attribute{0, offsetof(DiscShape, outline)}};
constexpr std::array triangle_attributes{Attribute{2, offsetof(TriangleShape, a)},
                                         Attribute{2, offsetof(TriangleShape, b)},
                                         Attribute{2, offsetof(TriangleShape, c)},
                                         Attribute{1, offsetof(TriangleShape, outline_width)},
                                         Attribute{0, offsetof(TriangleShape, fill)},
                                         Attribute{0, offsetof(TriangleShape, outline)}};

Layout layout_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::segment:
      return {sizeof(SegmentShape), sizeof(SegmentShape), segment_attributes};
    case ShapeKind::arrow:
      return {sizeof(ArrowShape), sizeof(ArrowShape) + sizeof(float), arrow_attributes};
    case ShapeKind::disc:
      return {sizeof(DiscShape), sizeof(DiscShape), disc_attributes};
    case ShapeKind::triangle:
      return {sizeof(TriangleShape), sizeof(TriangleShape), triangle_attributes};
    case ShapeKind::box:
      break;
  }
  return {sizeof(BoxShape), sizeof(BoxShape), box_attributes};
}

const void* shapes_of(const DrawList& list, ShapeKind kind) {
  switch (kind) {
    case ShapeKind::segment:
      return list.segments.data();
    case ShapeKind::arrow:
      return list.arrows.data();
    case ShapeKind::disc:
      return list.discs.data();
    case ShapeKind::triangle:
      return list.triangles.data();
    case ShapeKind::box:
      break;
  }
  return list.boxes.data();
}

/// What a vertex of an arrow carries behind the shape: the part of the arrow that its quad is around.
constexpr float whole_arrow = 0.0F;
constexpr float shaft_of_arrow = 1.0F;
constexpr float head_of_arrow = 2.0F;

/// True where a second quad would cost more than the pixels beside the shaft that it saves.
bool takes_one_quad(const ArrowShape& arrow) {
  constexpr float quad_cost = 300.0F;  // px
  const float length = std::hypot(arrow.tip.x - arrow.tail.x, arrow.tip.y - arrow.tail.y);
  return 2.0F * length * (arrow.head_half_width - arrow.half_width) < quad_cost;
}

GLuint compile(const GlFunctions& gl, GLenum stage, std::string_view source) {
  const GLuint shader = gl.CreateShader(stage);
  const char* text = source.data();
  const auto length = static_cast<GLint>(source.size());
  gl.ShaderSource(shader, 1, &text, &length);
  gl.CompileShader(shader);
  GLint done = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == GL_FALSE) {
    std::array<char, 1024> log{};
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw LibraryError(std::string("a shader does not compile: ") + log.data());
  }
  return shader;
}

}  // namespace

ShapePipeline::ShapePipeline(const GlFunctions& gl, ShapeKind kind)
    : gl_(gl), kind_(kind), shape_size_(layout_of(kind).shape), stride_(layout_of(kind).stride) {
  const ShaderSource source = embedded_shader(kind);
  program_ = gl_.CreateProgram();
  for (const GLuint shader : {compile(gl_, GL_VERTEX_SHADER, source.vertex),
                              compile(gl_, GL_FRAGMENT_SHADER, source.fragment)}) {
    gl_.AttachShader(program_, shader);
    gl_.DeleteShader(shader);
  }
  gl_.LinkProgram(program_);
  GLint linked = GL_FALSE;
  gl_.GetProgramiv(program_, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    std::array<char, 1024> log{};
    gl_.GetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw LibraryError(std::string("a shader does not link: ") + log.data());
  }
  picture_ = gl_.GetUniformLocation(program_, "picture");
  describe_vertices();
}

ShapePipeline::~ShapePipeline() {
  gl_.DeleteProgram(program_);
  gl_.DeleteBuffers(1, &vertex_buffer_);
  gl_.DeleteBuffers(1, &index_buffer_);
  gl_.DeleteVertexArrays(1, &vertex_array_);
}

void ShapePipeline::describe_vertices() {
  gl_.GenVertexArrays(1, &vertex_array_);
  gl_.BindVertexArray(vertex_array_);
  gl_.GenBuffers(1, &index_buffer_);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  gl_.GenBuffers(1, &vertex_buffer_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  const Layout layout = layout_of(kind_);
  GLuint index = 0;
  for (const Attribute& attribute : layout.attributes) {
    const bool color = attribute.floats == 0;
    // OpenGL wants an offset into the buffer as a pointer.
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    const auto* const offset = reinterpret_cast<const void*>(attribute.offset);
    gl_.EnableVertexAttribArray(index);
    gl_.VertexAttribPointer(index, color ? 4 : attribute.floats,
                            color ? GL_UNSIGNED_BYTE : GL_FLOAT, color ? GL_TRUE : GL_FALSE,
                            static_cast<GLsizei>(layout.stride), offset);
    ++index;
  }
}

void ShapePipeline::make_indices(std::size_t quads) {
  if (quads <= indexed_quads_) return;
  indexed_quads_ = quads;
  std::vector<std::uint32_t> indices;
  indices.reserve(indices_of_quad * quads);
  for (std::size_t quad = 0; quad < quads; ++quad) {
    const auto first = static_cast<std::uint32_t>(vertices_of_quad * quad);
    indices.insert(indices.end(), {first, first + 1, first + 2, first + 2, first + 1, first + 3});
  }
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof indices.front()), indices.data(),
                 GL_STATIC_DRAW);
}

/// The corners of a quad around a shape.
void ShapePipeline::add_quad(const std::byte* shape) {
  for (std::size_t copy = 0; copy < vertices_of_quad; ++copy)
    vertices_.insert(vertices_.end(), shape, shape + shape_size_);
}

/// The same around a part of an arrow.
void ShapePipeline::add_quad(const std::byte* shape, float part) {
  const auto* const bytes = reinterpret_cast<const std::byte*>(&part);
  for (std::size_t copy = 0; copy < vertices_of_quad; ++copy) {
    vertices_.insert(vertices_.end(), shape, shape + shape_size_);
    vertices_.insert(vertices_.end(), bytes, bytes + sizeof part);
  }
}

void ShapePipeline::add_quads(const DrawList& list, std::size_t i) {
  const std::byte* const shape =
      static_cast<const std::byte*>(shapes_of(list, kind_)) + i * shape_size_;
  if (kind_ != ShapeKind::arrow) {
    add_quad(shape);
  } else if (takes_one_quad(list.arrows[i])) {
    add_quad(shape, whole_arrow);
  } else {
    add_quad(shape, shaft_of_arrow);
    add_quad(shape, head_of_arrow);
  }
}

void ShapePipeline::draw(const DrawList& list, const ShapeRun& run, const Region& region) {
  vertices_.clear();
  for (std::size_t i = run.first; i < run.first + run.count; ++i)
    if (touches(list, kind_, i, region)) add_quads(list, i);
  if (vertices_.empty()) return;
  gl_.UseProgram(program_);
  gl_.Uniform2f(picture_, static_cast<float>(list.width), static_cast<float>(list.height));
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  draw_quads(vertices_.size() / (vertices_of_quad * stride_));
}

void ShapePipeline::draw_quads(std::size_t count) {
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size()), vertices_.data(),
                 GL_STREAM_DRAW);
  make_indices(count);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices_of_quad * count), GL_UNSIGNED_INT,
                   nullptr);
}

}  // namespace wuerfel::internal
