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
void undo_premultiplication(const RowRange& rows, Image& image) {
  for (int y = rows.begin; y < rows.end; ++y) {
    std::uint8_t* pixel = image.row(y) + 4 * static_cast<std::ptrdiff_t>(rows.left);
    for (int x = rows.left; x < std::min(rows.right, image.width()); ++x, pixel += 4) {
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

  /// Draws the shapes of `list`, without its texts: only what has changed since the picture before,
  /// which the canvas keeps. Returns the rows that have changed, those of texts included.
  RowSet draw(const DrawList& list) {
    context_.use_canvas(list.width, list.height);
    const internal::Region region = region_to_draw(list);
    RowSet rows = changed_rows(list, region);
    last_.reset();
    clear(list, region);
    const internal::GlFunctions& gl = context_.gl();
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const ShapeRun& run : list.runs)
      pipeline(run.kind).draw(list, run, region);
    last_ = list;
    return rows;
  }
  /// The rows as they were drawn.
  void read(const RowSet& rows, Image& image) { context_.read(rows, image); }
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

  RowSet changed_rows(const DrawList& list, const internal::Region& region) const {
    RowSet rows(RowRange{region.top, region.bottom, region.left, region.right});
    if (region != internal::whole_picture(list))
      rows.add(internal::changed_text_rows(*last_, list));
    return rows;
  }

  /// Fills the region with the background; nothing outside of it will be drawn.
  void clear(const DrawList& list, const internal::Region& region) {
    if (region == internal::whole_picture(list)) {
      context_.clear(list.background);
    } else {
      context_.clear(region, list.background);
    }
  }

  internal::ShapePipeline& pipeline(ShapeKind kind) {
    std::unique_ptr<internal::ShapePipeline>& entry = pipelines_.at(static_cast<std::size_t>(kind));
    if (!entry) entry = std::make_unique<internal::ShapePipeline>(context_.gl(), kind);
    return *entry;
  }

  internal::OffscreenContext context_;
  std::array<std::unique_ptr<internal::ShapePipeline>, 5> pipelines_;
  std::optional<DrawList> last_;  ///< what the context shows
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

/// A text that is drawn is drawn wholly, on rows without any of it.
void add_rows_of_texts(const DrawList& list, RowSet& rows) {
  for (bool grown = true; grown;) {
    const RowSet before = rows;
    for (const TextShape& text : list.texts) {
      const RowRange own = internal::rows_of(text, list.height);
      if (rows.touches(own)) rows.add(own);
    }
    grown = rows != before;
  }
}

}  // namespace

RowSet Renderer::draw(const DrawList& list, Image& image, const std::optional<RowSet>& stale) {
  const RowRange all{0, list.height};
  const bool is_new = image.width() != list.width || image.height() != list.height;
  if (is_new) image = Image(list.width, list.height);
  if (list.exact) {
    fill_exactly(list, image);
    return all;
  }
  RowSet changed = gl_->draw(list);
  RowSet rows = is_new || !stale ? all : *stale;
  rows.add(changed);
  add_rows_of_texts(list, rows);
  gl_->read(rows, image);
  for (const TextShape& text : list.texts) {
    if (rows.touches(internal::rows_of(text, list.height)))
      internal::blend_text(text, font_, image);
  }
  if (list.background.a != 255) {
    for (const RowRange& range : rows.ranges())
      undo_premultiplication(range, image);
  }
  return changed;
}

}  // namespace wuerfel
