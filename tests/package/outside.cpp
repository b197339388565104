// What another project does with the library: read a scene, ask, move, draw.
#include <cstdio>

#include "core/check.h"
#include "core/scene/scene_parser.h"
#include "core/time/simulation.h"
#include "render/raster/draw_frame.h"
#include "render/raster/renderer.h"

int main() {
  using namespace wuerfel;
  const Scene scene =
      parse_scene("[[plane]]\nname = 'floor'\n[[tower]]\ncount = 3\non = 'floor'\n", "three cubes");
  MotionSettings referee;
  referee.solver = QpMethod::ipopt;
  const bool stands = check(scene, {}).verdict == Verdict::stands
                      && check(scene, referee).verdict == Verdict::stands;

  Simulation simulation(scene, {});
  simulation.advance_to(0.5);
  SnapshotRequest request;
  request.forces = true;
  const Snapshot snapshot = simulation.snapshot(request);

  Renderer renderer;
  const Style style = make_style(Theme::light);
  FrameOptions options;
  Bounds bounds;
  bounds.include(snapshot, options.force_scale);
  const View view = fit_view(bounds, 320, 180, frame_insets(style, options, 320, 180));
  Image image;
  draw_frame(renderer, snapshot, view, style, options, image);
  std::printf("%s, %d forces, %d x %d pixels\n", stands ? "stands" : "falls",
              static_cast<int>(snapshot.forces.size()), image.width(), image.height());
  return stands && snapshot.forces.size() == 6 ? 0 : 1;
}
