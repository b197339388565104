#include "render/renderer.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "render/embedded.h"
#include "render/error.h"
#include "render/text.h"

namespace wuerfel {
namespace {

/// One vertex attribute: `floats` floats, or a colour of four bytes.
struct Attribute {
  int floats = 0;  ///< 0: colour
  std::size_t offset = 0;
};

struct Layout {
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

const void* first_shape(const DrawList& list, const ShapeRun& run) {
  switch (run.kind) {
    case ShapeKind::segment:
      return list.segments.data() + run.first;
    case ShapeKind::arrow:
      return list.arrows.data() + run.first;
    case ShapeKind::disc:
      return list.discs.data() + run.first;
    case ShapeKind::triangle:
      return list.triangles.data() + run.first;
    case ShapeKind::box:
      break;
  }
  return list.boxes.data() + run.first;
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
    throw RenderError(std::string("a shader does not compile: ") + log.data());
  }
  return shader;
}

/// What was blended over nothing has premultiplied colours; an image has straight alpha.
void undo_premultiplication(Image& image) {
  for (int y = 0; y < image.height(); ++y) {
    std::uint8_t* pixel = image.row(y);
    for (int x = 0; x < image.width(); ++x, pixel += 4) {
      const unsigned alpha = pixel[3];
      if (alpha == 0 || alpha == 255) continue;
      for (int c = 0; c < 3; ++c) {
        const unsigned straight = (255U * pixel[c] + alpha / 2U) / alpha;
        pixel[c] = static_cast<std::uint8_t>(straight > 255U ? 255U : straight);
      }
    }
  }
}

}  // namespace

class Renderer::Pipeline {
 public:
  Pipeline(const GlFunctions& gl, ShapeKind kind)
      : gl_(gl), stride_(layout_of(kind).stride), vertices_(kind == ShapeKind::arrow ? 8 : 4) {
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
      throw RenderError(std::string("a shader does not link: ") + log.data());
    }
    picture_ = gl_.GetUniformLocation(program_, "picture");
    describe_instances(layout_of(kind));
  }
  ~Pipeline() {
    gl_.DeleteProgram(program_);
    gl_.DeleteBuffers(1, &buffer_);
    gl_.DeleteVertexArrays(1, &vertex_array_);
  }
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;
  Pipeline(Pipeline&&) = delete;
  Pipeline& operator=(Pipeline&&) = delete;

  /// One instanced draw for all shapes of a run.
  void draw(const void* shapes, std::size_t count, const Image& image) {
    gl_.UseProgram(program_);
    gl_.Uniform2f(picture_, static_cast<float>(image.width()), static_cast<float>(image.height()));
    gl_.BindVertexArray(vertex_array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * stride_), shapes,
                   GL_STREAM_DRAW);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, vertices_, static_cast<GLsizei>(count));
  }

 private:
  void describe_instances(const Layout& layout) {
    gl_.GenVertexArrays(1, &vertex_array_);
    gl_.BindVertexArray(vertex_array_);
    gl_.GenBuffers(1, &buffer_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
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
      gl_.VertexAttribDivisor(index, 1);
      ++index;
    }
  }

  const GlFunctions& gl_;
  std::size_t stride_;
  GLsizei vertices_;  ///< of a strip around one shape
  GLuint program_ = 0;
  GLuint vertex_array_ = 0;
  GLuint buffer_ = 0;
  GLint picture_ = -1;
};

Renderer::Renderer(RasterThreads threads) : context_(threads) {}

Renderer::~Renderer() = default;

Renderer::Pipeline& Renderer::pipeline(ShapeKind kind) {
  std::unique_ptr<Pipeline>& entry = pipelines_.at(static_cast<std::size_t>(kind));
  if (!entry) entry = std::make_unique<Pipeline>(context_.gl(), kind);
  return *entry;
}

void Renderer::draw(const DrawList& list, Image& image) {
  if (image.width() != list.width || image.height() != list.height) {
    image = Image(list.width, list.height);
  }
  const GlFunctions& gl = context_.gl();
  context_.draw_into(image);
  const Color ground = list.background;
  const float alpha = static_cast<float>(ground.a) / 255.0F;
  gl.ClearColor(static_cast<float>(ground.r) / 255.0F * alpha,
                static_cast<float>(ground.g) / 255.0F * alpha,
                static_cast<float>(ground.b) / 255.0F * alpha, alpha);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const ShapeRun& run : list.runs) {
    pipeline(run.kind).draw(first_shape(list, run), run.count, image);
  }
  gl.Finish();
  if (const GLenum error = gl.GetError(); error != GL_NO_ERROR) {
    throw RenderError("OpenGL reports error " + std::to_string(error));
  }
  for (const TextShape& text : list.texts)
    blend_text(text, font_, image);
  if (list.background.a != 255) undo_premultiplication(image);
}

}  // namespace wuerfel
