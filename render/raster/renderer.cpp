#include "render/raster/renderer.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "render/error.h"
#include "render/raster/offscreen_context.h"
#include "render/raster/shape_pipeline.h"
#include "render/raster/text.h"

namespace wuerfel {
namespace {

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

/// The context, and the pipeline of each kind of shape from the first one drawn on.
class Renderer::OpenGl {
 public:
  explicit OpenGl(RasterThreads threads) : context_(threads) {}

  /// The shapes of `list`, without its texts.
  void draw(const DrawList& list, Image& image) {
    const internal::GlFunctions& gl = context_.gl();
    context_.draw_into(image);
    const Color ground = list.background;
    const float alpha = static_cast<float>(ground.a) / 255.0F;
    gl.ClearColor(static_cast<float>(ground.r) / 255.0F * alpha,
                  static_cast<float>(ground.g) / 255.0F * alpha,
                  static_cast<float>(ground.b) / 255.0F * alpha, alpha);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const ShapeRun& run : list.runs)
      pipeline(run.kind).draw(list, run);
    gl.Finish();
    if (const GLenum error = gl.GetError(); error != GL_NO_ERROR)
      throw RenderError("OpenGL reports error " + std::to_string(error));
  }
  const std::string& description() const { return context_.description(); }

 private:
  internal::ShapePipeline& pipeline(ShapeKind kind) {
    std::unique_ptr<internal::ShapePipeline>& entry = pipelines_.at(static_cast<std::size_t>(kind));
    if (!entry) entry = std::make_unique<internal::ShapePipeline>(context_.gl(), kind);
    return *entry;
  }

  internal::OffscreenContext context_;
  std::array<std::unique_ptr<internal::ShapePipeline>, 5> pipelines_;
};

Renderer::Renderer(RasterThreads threads) : gl_(std::make_unique<OpenGl>(threads)) {}

Renderer::~Renderer() = default;

Font& Renderer::font() { return font_; }

const std::string& Renderer::description() const { return gl_->description(); }

void Renderer::draw(const DrawList& list, Image& image) {
  if (image.width() != list.width || image.height() != list.height)
    image = Image(list.width, list.height);
  gl_->draw(list, image);
  for (const TextShape& text : list.texts)
    internal::blend_text(text, font_, image);
  if (list.background.a != 255) undo_premultiplication(image);
}

}  // namespace wuerfel
