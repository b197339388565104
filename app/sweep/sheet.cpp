#include "app/sweep/sheet.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/film/origin.h"
#include "app/sweep/sample_pictures.h"
#include "app/sweep/statics.h"
#include "core/scene/scene_parser.h"
#include "render/picture/compose_frame.h"

namespace wuerfel {

namespace {

DrawList first_frame(const Scene& scene,
                     const PictureOptions& options,
                     const StopSignal& stop,
                     Font& font) {
  const Simulation simulation(scene, {});
  const Snapshot first = simulation.snapshot(snapshot_request(options, scene.cubes.size()));
  const PictureOptions fitted = fit_to_first(options, scene, first, stop);
  return compose_frame(first, view_of(fitted, first), make_style(fitted.theme),
                       frame_options(fitted), font);
}

// "stands 12.5 %": the verdict, and how nearly.
std::string caption(const Scene& scene) {
  Statics statics(scene);
  std::string verdict(to_string(statics.check().verdict));
  if (!statics.nearest()) return verdict;
  return fmt::format("{} {:.1f} %", verdict, 100.0 * statics.nearest()->margin);
}

StripLayout sheet_layout(const SheetChoice& choice, std::size_t cases) {
  const auto [width, height] = choice.size.value_or(PixelSize{1600, 1760});
  StripLayout layout = strip_layout(choice.grid, width, height, 1.0);
  const std::size_t columns = choice.grid.columns;
  const std::size_t filled = (cases + columns - 1) / columns * columns;
  if (!choice.size) layout.height = std::min(layout.height, cell_place(layout, filled).y);
  return layout;
}

}  // namespace

Still contact_sheet(const Plan& plan,
                    const SheetChoice& choice,
                    const StopSignal& stop,
                    Font& font) {
  const auto cells = static_cast<long>(choice.grid.columns) * choice.grid.rows;
  const std::vector<Case> cases = spread_cases(plan, cells);
  const StripLayout layout = sheet_layout(choice, cases.size());
  PictureOptions options = picture_options(plan.sweep().files);
  options.size = {layout.cell_width, layout.cell_height};
  Still sheet;
  sheet.origin = {{software_key, "wuerfel " WUERFEL_VERSION}, {"Sweep plan", plan.hash()}};
  std::vector<std::string> captions;
  for (const Case& one : cases) {
    stop.check();
    const Scene scene = scene_of(plan.sweep(), one.values);
    const CellPlace place = cell_place(layout, captions.size());
    sheet.cells.push_back({first_frame(scene, options, stop, font), place.x, place.y});
    captions.push_back(caption(scene));
  }
  sheet.page = strip_page(captions, layout, make_style(options.theme));
  return sheet;
}

}  // namespace wuerfel
