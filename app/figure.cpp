#include "app/accuracy.h"
#include "app/advance.h"
#include "app/commands.h"
#include "app/picture.h"
#include "app/recording.h"
#include "core/scene/scene_parser.h"
#include "render/output_file.h"

namespace wuerfel {

ExitCode figure(const FigureOptions& options) {
  const Scene scene = read_scene(options.scene);
  Simulation simulation(scene, options.motion);
  OutputFile file(options.output);
  const StopSignal stop;
  Progress silent(Progress::Style::silent, "simulating", options.time, "s");
  advance(simulation, options.time, options.motion.step, stop, silent);

  Recording still;
  still.add(simulation.snapshot(snapshot_request(options.picture.layers)));
  Painter painter(still, options.picture);
  const std::string settings = painter.option_text() + " " + option_text(options.motion);
  file.write(encode_png(painter.draw(0), origin(options.time, settings, normalised_scene(scene))));
  file.commit();
  return verdict_on_accuracy(simulation.audit());
}

}  // namespace wuerfel
