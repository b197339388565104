#include "render/raster/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "render/raster/changed_region.h"
#include "render/raster/offscreen_context.h"
#include "render/raster/scan_lines.h"
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
  /// Draws the shapes of `list`, without its texts, and copies these rows.
  void draw(const DrawList& list, const RowSet& rows, Image& image) {
    context_.use_canvas(list.width, list.height);
    context_.clear(list.background);
    const internal::GlFunctions& gl = context_.gl();
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const ShapeRun& run : list.runs)
      pipeline(run.kind).draw(list, run);
    context_.read(rows, image);
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

std::string_view to_string(Rasteriser rasteriser) {
  switch (rasteriser) {
    case Rasteriser::scan_lines:
      return "scan-lines";
    case Rasteriser::osmesa:
      return "osmesa";
  }
  return "?";
}

Renderer::Renderer(Rasteriser rasteriser) {
  if (rasteriser == Rasteriser::osmesa) gl_ = std::make_unique<OpenGl>();
}

Renderer::~Renderer() = default;

Font& Renderer::font() { return font_; }

std::string Renderer::description() const {
  return gl_ ? gl_->description() : std::string(to_string(Rasteriser::scan_lines));
}

namespace {

/// Each pixel whose middle lies in a box gets its colour; the last box wins.
void fill_exactly(const DrawList& list, Image& image) {
  image = Image(list.width, list.height, list.background);
  for (const BoxShape& box : list.boxes) {
    const float reach_x =
        std::abs(box.axis.x) * box.half_size.x + std::abs(box.axis.y) * box.half_size.y;
    const float reach_y =
        std::abs(box.axis.y) * box.half_size.x + std::abs(box.axis.x) * box.half_size.y;
    if (!std::isfinite(box.center.x + box.center.y + reach_x + reach_y)) continue;
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

RowSet changed_rows(const DrawList& before, const DrawList& after) {
  if (before.width != after.width || before.height != after.height
      || before.background != after.background)
    return RowRange{0, after.height};
  const internal::Region region = internal::changed_region(before, after);
  RowSet rows(RowRange{region.top, region.bottom, region.left, region.right});
  rows.add(internal::changed_text_rows(before, after));
  return rows;
}

}  // namespace

RowSet Renderer::draw(const DrawList& list, Image& image, const std::optional<RowSet>& stale) {
  const RowRange all{0, list.height};
  const bool is_new = image.width() != list.width || image.height() != list.height;
  if (is_new) image = Image(list.width, list.height);
  if (list.exact) {
    last_.reset();
    fill_exactly(list, image);
    return all;
  }
  RowSet changed = last_ ? changed_rows(*last_, list) : all;
  RowSet rows = is_new || !stale ? all : *stale;
  rows.add(changed);
  last_.reset();
  draw_shapes(list, rows, image);
  for (const RowRange& range : rows.ranges()) {
    for (const TextShape& text : list.texts)
      internal::blend_text(text, range, font_, image);
    if (list.background.a != 255) undo_premultiplication(range, image);
  }
  last_ = list;
  return changed;
}

void Renderer::draw_shapes(const DrawList& list, const RowSet& rows, Image& image) {
  if (gl_) return gl_->draw(list, rows, image);
  for (const RowRange& range : rows.ranges())
    internal::draw_scan_lines(list, range, image);
}

}  // namespace wuerfel
