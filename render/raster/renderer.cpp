#include "render/raster/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "render/error.h"
#include "render/raster/changed_region.h"
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

  /// The shapes of `list`, without its texts. The context keeps the picture before: only what has
  /// changed since is drawn. Returns the rows that have changed, those of texts included.
  RowRange draw(const DrawList& list, Image& image) {
    context_.draw_into(image);
    const internal::Region region = region_to_draw(list);
    const RowRange rows = changed_rows(list, region);
    last_.reset();
    clear(list, region);
    const internal::GlFunctions& gl = context_.gl();
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    // Mesa draws the first shapes after a change of size for the size before: what it begins with is drawn twice.
    if (list.width != width_ || list.height != height_) {
      draw_shapes(list, region);
      gl.Finish();
      clear(list, region);
      width_ = list.width;
      height_ = list.height;
    }
    draw_shapes(list, region);
    gl.Finish();
    if (const GLenum error = gl.GetError(); error != GL_NO_ERROR)
      throw LibraryError("OpenGL reports error " + std::to_string(error));
    last_ = list;
    return rows;
  }
  const std::string& description() const { return context_.description(); }

 private:
  internal::Region region_to_draw(const DrawList& list) const {
    const internal::Region whole = internal::whole_picture(list);
    const bool comparable = last_ && last_->width == list.width && last_->height == list.height
                            && last_->background == list.background;
    if (!comparable) return whole;
    const internal::Region changed = internal::changed_region(*last_, list);
    // A whole picture is cleared faster than a part of it.
    constexpr double large = 0.8;
    const double area = static_cast<double>(changed.width()) * changed.height();
    return area > large * whole.width() * whole.height() ? whole : changed;
  }

  RowRange changed_rows(const DrawList& list, const internal::Region& region) const {
    if (region == internal::whole_picture(list)) return {0, list.height};
    const RowRange texts = internal::changed_text_rows(*last_, list);
    return {std::min(region.top, texts.begin), std::max(region.bottom, texts.end)};
  }

  /// Fills the region with the background; nothing outside of it will be drawn.
  void clear(const DrawList& list, const internal::Region& region) {
    const internal::GlFunctions& gl = context_.gl();
    if (region == internal::whole_picture(list)) {
      gl.Disable(GL_SCISSOR_TEST);
    } else {
      gl.Enable(GL_SCISSOR_TEST);
      gl.Scissor(region.left, list.height - region.bottom, region.width(), region.height());
    }
    const Color ground = list.background;
    const float alpha = static_cast<float>(ground.a) / 255.0F;
    gl.ClearColor(static_cast<float>(ground.r) / 255.0F * alpha,
                  static_cast<float>(ground.g) / 255.0F * alpha,
                  static_cast<float>(ground.b) / 255.0F * alpha, alpha);
    gl.Clear(GL_COLOR_BUFFER_BIT);
  }

  void draw_shapes(const DrawList& list, const internal::Region& region) {
    for (const ShapeRun& run : list.runs)
      pipeline(run.kind).draw(list, run, region);
  }

  internal::ShapePipeline& pipeline(ShapeKind kind) {
    std::unique_ptr<internal::ShapePipeline>& entry = pipelines_.at(static_cast<std::size_t>(kind));
    if (!entry) entry = std::make_unique<internal::ShapePipeline>(context_.gl(), kind);
    return *entry;
  }

  internal::OffscreenContext context_;
  std::array<std::unique_ptr<internal::ShapePipeline>, 5> pipelines_;
  std::optional<DrawList> last_;  ///< what the context shows
  int width_ = 0;                 ///< px, of the picture before
  int height_ = 0;                ///< px, likewise
};

Renderer::Renderer(RasterThreads threads) : gl_(std::make_unique<OpenGl>(threads)) {}

Renderer::~Renderer() = default;

Font& Renderer::font() { return font_; }

const std::string& Renderer::description() const { return gl_->description(); }

namespace {

/// Each pixel whose middle lies in a box gets its colour; the last box wins.
void fill_exactly(const DrawList& list, Image& image) {
  image = Image(list.width, list.height, list.background);
  for (const BoxShape& box : list.boxes) {
    const float reach_x =
        std::abs(box.axis.x) * box.half_size.x + std::abs(box.axis.y) * box.half_size.y;
    const float reach_y =
        std::abs(box.axis.y) * box.half_size.x + std::abs(box.axis.x) * box.half_size.y;
    const auto pixel = [](float at, int end) {
      return static_cast<int>(std::clamp(std::floor(at), 0.0F, static_cast<float>(end)));
    };
    const int right = pixel(box.center.x + reach_x + 1.0F, list.width);
    const int bottom = pixel(box.center.y + reach_y + 1.0F, list.height);
    for (int y = pixel(box.center.y - reach_y, list.height); y < bottom; ++y) {
      for (int x = pixel(box.center.x - reach_x, list.width); x < right; ++x) {
        const float dx = static_cast<float>(x) + 0.5F - box.center.x;
        const float dy = static_cast<float>(y) + 0.5F - box.center.y;
        const bool inside = std::abs(dx * box.axis.x + dy * box.axis.y) <= box.half_size.x
                            && std::abs(dy * box.axis.x - dx * box.axis.y) <= box.half_size.y;
        if (inside) image.set(x, y, box.fill);
      }
    }
  }
}

}  // namespace

RowRange Renderer::draw(const DrawList& list, Image& image) {
  if (image.width() != list.width || image.height() != list.height)
    image = Image(list.width, list.height);
  if (list.exact) {
    fill_exactly(list, image);
    return {0, list.height};
  }
  const RowRange changed = gl_->draw(list, image);
  for (const TextShape& text : list.texts)
    internal::blend_text(text, font_, image);
  if (list.background.a != 255) undo_premultiplication(image);
  return changed;
}

}  // namespace wuerfel
