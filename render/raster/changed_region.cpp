#include "render/raster/changed_region.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "render/raster/extent.h"

namespace wuerfel::internal {
namespace {

/// The smallest region around all that was added, cut off at the picture.
class GrowingRegion {
 public:
  explicit GrowingRegion(const Region& picture)
      : picture_(picture), region_{picture.right, picture.bottom, picture.left, picture.top} {}

  void add(const Extent& extent) {
    const auto place = [](float pixel, int low, int high) {
      return static_cast<int>(
          std::clamp(std::floor(pixel), static_cast<float>(low), static_cast<float>(high)));
    };
    const Extent& e = extent;
    if (!std::isfinite(e.left + e.top + e.right + e.bottom)) {
      region_ = picture_;
      return;
    }
    region_.left = std::min(region_.left, place(e.left, picture_.left, picture_.right));
    region_.top = std::min(region_.top, place(e.top, picture_.top, picture_.bottom));
    region_.right = std::max(region_.right, place(e.right + 1.0F, picture_.left, picture_.right));
    region_.bottom =
        std::max(region_.bottom, place(e.bottom + 1.0F, picture_.top, picture_.bottom));
  }

  Region region() const {
    if (region_.width() > 0 && region_.height() > 0) return region_;
    return {picture_.left, picture_.top, picture_.left + 1, picture_.top + 1};
  }

 private:
  Region picture_;
  Region region_;
};

/// All shapes of a run from its `from`-th on.
void add_shapes(const DrawList& list,
                const ShapeRun& run,
                std::size_t from,
                GrowingRegion& region) {
  with_shapes(list, run.kind, [&](const auto& shapes) {
    for (std::size_t i = from; i < run.count; ++i)
      region.add(extent(shapes[run.first + i]));
  });
}

/// Shapes of one kind that differ, of `count`.
template <class Shape>
void add_changed(const Shape* before,
                 const Shape* after,
                 std::size_t count,
                 GrowingRegion& region) {
  for (std::size_t i = 0; i < count; ++i) {
    if (before[i] == after[i]) continue;
    region.add(extent(before[i]));
    region.add(extent(after[i]));
  }
}

/// The shapes that differ in two runs of one kind.
void add_differences(const DrawList& before,
                     const ShapeRun& old_run,
                     const DrawList& after,
                     const ShapeRun& new_run,
                     GrowingRegion& region) {
  const std::size_t common = std::min(old_run.count, new_run.count);
  with_shapes(after, new_run.kind, [&](const auto& shapes) {
    using Shapes = std::remove_cvref_t<decltype(shapes)>;
    with_shapes(before, old_run.kind, [&](const auto& old_shapes) {
      if constexpr (std::is_same_v<Shapes, std::remove_cvref_t<decltype(old_shapes)>>) {
        add_changed(old_shapes.data() + old_run.first, shapes.data() + new_run.first, common,
                    region);
      }
    });
  });
  add_shapes(before, old_run, common, region);
  add_shapes(after, new_run, common, region);
}

}  // namespace

Region whole_picture(const DrawList& list) { return {0, 0, list.width, list.height}; }

Region changed_region(const DrawList& before, const DrawList& after) {
  GrowingRegion region(whole_picture(after));
  std::size_t i = 0;
  const std::size_t common = std::min(before.runs.size(), after.runs.size());
  // Where kinds differ, shapes have changed their place in the painting order.
  for (; i < common && before.runs[i].kind == after.runs[i].kind; ++i)
    add_differences(before, before.runs[i], after, after.runs[i], region);
  for (std::size_t j = i; j < before.runs.size(); ++j)
    add_shapes(before, before.runs[j], 0, region);
  for (std::size_t j = i; j < after.runs.size(); ++j)
    add_shapes(after, after.runs[j], 0, region);
  return region.region();
}

RowRange rows_of(const TextShape& text, int height) {
  if (!std::isfinite(text.baseline.y)) return {0, height};
  const auto place = [&](float y) {
    return static_cast<int>(std::clamp(y, 0.0F, static_cast<float>(height)));
  };
  // No letter is higher, or hangs deeper, than twice its size.
  const float reach = 2.0F * text.size + text.halo_width + 1.0F;
  return {place(text.baseline.y - reach), place(text.baseline.y + reach)};
}

RowSet changed_text_rows(const DrawList& before, const DrawList& after) {
  RowSet rows;
  const std::size_t most = std::max(before.texts.size(), after.texts.size());
  for (std::size_t i = 0; i < most; ++i) {
    const bool was = i < before.texts.size();
    const bool is = i < after.texts.size();
    if (was && is && before.texts[i] == after.texts[i]) continue;
    if (was) rows.add(rows_of(before.texts[i], after.height));
    if (is) rows.add(rows_of(after.texts[i], after.height));
  }
  return rows;
}

}  // namespace wuerfel::internal
