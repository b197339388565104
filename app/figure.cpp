#include <fmt/core.h>

#include "app/commands.h"
#include "app/picture.h"
#include "app/recording.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

ExitCode figure(const FigureOptions& options) {
  const Scene scene = read_scene(options.scene);
  Simulation simulation(scene, options.motion);
  simulation.advance_to(options.time);

  Recording still;
  still.add(simulation.snapshot(snapshot_request(options.picture.layers)));
  Painter painter(still, options.picture);
  const std::string settings =
      fmt::format("{} {}", painter.option_text(), option_text(options.motion));
  write_png(options.output, painter.draw(0),
            origin(options.time, settings, normalised_scene(scene)));
  return simulation.audit().missed_solves == 0 ? ExitCode::fine : ExitCode::undecided;
}

}  // namespace wuerfel
