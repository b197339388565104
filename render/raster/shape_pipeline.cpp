#include "render/raster/shape_pipeline.h"

#include <array>
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
    Attribute{4, offsetof(ArrowShape, half_width)}, Attribute{0, offsetof(ArrowShape, color)}};
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
      return {sizeof(SegmentShape), segment_attributes};
    case ShapeKind::arrow:
      return {sizeof(ArrowShape), arrow_attributes};
    case ShapeKind::disc:
      return {sizeof(DiscShape), disc_attributes};
    case ShapeKind::triangle:
      return {sizeof(TriangleShape), triangle_attributes};
    case ShapeKind::box:
      break;
  }
  return {sizeof(BoxShape), box_attributes};
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
    : gl_(gl), kind_(kind), shape_size_(layout_of(kind).shape) {
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
                            static_cast<GLsizei>(layout.shape), offset);
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

void ShapePipeline::draw(const DrawList& list, const ShapeRun& run) {
  vertices_.clear();
  with_shapes(list, kind_, [&](const auto& shapes) {
    const auto* const bytes = reinterpret_cast<const std::byte*>(shapes.data() + run.first);
    for (std::size_t i = 0; i < run.count * vertices_of_quad; ++i) {
      const std::byte* const shape = bytes + i / vertices_of_quad * shape_size_;
      vertices_.insert(vertices_.end(), shape, shape + shape_size_);
    }
  });
  gl_.UseProgram(program_);
  gl_.Uniform2f(picture_, static_cast<float>(list.width), static_cast<float>(list.height));
  gl_.BindVertexArray(vertex_array_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  draw_quads(run.count);
}

void ShapePipeline::draw_quads(std::size_t count) {
  gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size()), vertices_.data(),
                 GL_STREAM_DRAW);
  make_indices(count);
  gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices_of_quad * count), GL_UNSIGNED_INT,
                   nullptr);
}

}  // namespace wuerfel::internal
