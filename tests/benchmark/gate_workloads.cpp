/// The work whose instructions tests/benchmark/gate counts, one piece after the other:
///
///     valgrind --tool=callgrind --instr-atstart=no build/release/tests/gate_workloads
///
/// Callgrind counts only between the two marks of count(), so that start-up and making scenes are
/// left out, and writes one file per piece, named in its line
/// "desc: Trigger". Run without valgrind it does the same work and counts nothing.
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <valgrind/callgrind.h>

#include "core/qp/qp_solver.h"
#include "core/time/simulation.h"
#include "render/files/png.h"
#include "render/picture/compose_frame.h"
#include "tests/benchmark/bench/scenes.h"
#include "tests/support/qp_zoo.h"

namespace {

using namespace wuerfel;

template <class Work>
void count(const std::string& name, Work&& work) {
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  work();
  CALLGRIND_DUMP_STATS_AT(name.c_str());
  CALLGRIND_STOP_INSTRUMENTATION;
}

constexpr std::size_t order = 60;
using Matrix = std::array<std::array<double, order>, order>;

/// The Hilbert matrix plus the identity; what is below the diagonal is enough.
void fill(Matrix& a) {
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      a[i][j] = 1.0 / static_cast<double>(i + j + 1);
    a[i][i] = 1.0 / static_cast<double>(2 * i + 1) + 1.0;
  }
}

/// A = L L', in place.
void factorise(Matrix& a) {
  for (std::size_t i = 0; i < order; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = a[i][j];
      for (std::size_t k = 0; k < j; ++k)
        rest -= a[i][k] * a[j][k];
      a[i][j] = i == j ? std::sqrt(rest) : rest / a[j][j];
    }
  }
}

/// The measure of all others: plain work that never changes, so that a ratio to it says the same
/// after a change of compiler that makes everything a little longer or shorter.
void count_kernel() {
  static Matrix a;
  count("kernel", [] {
    for (int round = 0; round < 10; ++round) {
      fill(a);
      factorise(a);
    }
  });
  volatile double keep = a[order - 1][order - 1];  // else nothing of it need be done
  static_cast<void>(keep);
}

/// Making the simulation, moving it to the end of the scene, taking it down.
void count_motion(const std::string& scene) {
  const BenchScene bench = make_bench_scene(scene);
  count(scene, [&] {
    Simulation simulation(bench.scene, MotionSettings{});
    simulation.advance_to(bench.scene.duration);
  });
}

/// A crowded bin up to `end` s: long enough that it does not matter much how exactly cubes fall.
void count_bin(Integrator integrator, double end) {
  const BenchScene bench = make_bench_scene("pile_30");
  const MotionSettings settings{.integrator = integrator};
  count(bench.name + " by " + std::string(to_string(integrator)), [&] {
    Simulation simulation(bench.scene, settings);
    simulation.advance_to(end);
  });
}

/// One program with nothing remembered, then another that differs from it by a small step.
template <class Build>
void count_programs(const std::string& name, const Build& build) {
  test::ZooOptions options{.shift = 1e-3, .turn = 3e-4};
  const QuadraticProgram first = build(options);
  options.step = 1;
  const QuadraticProgram second = build(options);
  const std::unique_ptr<QpSolver> solver = make_qp_solver(QpMethod::automatic);
  QpResult result;
  count(name + " cold", [&] { solver->solve(first, result); });
  count(name + " warm", [&] { solver->solve(second, result); });
}

/// A picture of 91 cubes with rods and forces as a list of shapes, up to where Mesa takes over.
void count_composing() {
  const BenchScene bench = make_bench_scene("pyramid_13");
  const Simulation simulation(bench.scene, MotionSettings{});
  const Snapshot snapshot = simulation.snapshot({.forces = true, .rods = true});
  const Style style = make_style(Theme::light);
  FrameOptions options;
  options.layers = {Layer::cubes, Layer::rods, Layer::forces, Layer::hud};
  options.force_scale.metres_per_newton = 0.1;
  Bounds bounds;
  bounds.include(snapshot, options.force_scale);
  const View view = fit_view(bounds, 1280, 720, frame_insets(style, options, 1280, 720));
  Font font;
  count("compose pyramid_13",
        [&] { static_cast<void>(compose_frame(snapshot, view, style, options, font)); });
}

/// A flat picture, as all of ours are, to the compressed pixels of a PNG file.
void count_encoding() {
  Image image(1280, 720);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x)
      if ((x / 160 + y / 120) % 3 == 0) image.set(x, y, {0, 114, 178, 255});
  }
  ImageCompressor compressor;
  CompressedImage compressed;
  count("PNG 1280 x 720", [&] { compressor.compress(image, PngChannels::rgb, compressed); });
}

}  // namespace

int main() {
  count_kernel();
  for (const char* scene : {"tilt", "rider", "tower_100", "wall_10"})
    count_motion(scene);
  count_bin(Integrator::rattle, 1.0);
  count_bin(Integrator::automatic, 1.0);
  count_programs("tower 100", [](const test::ZooOptions& o) { return test::tower(100, o); });
  count_programs("pile 100", [](const test::ZooOptions& o) { return test::pile(100, o); });
  count_programs("wall 10 x 10", [](const test::ZooOptions& o) { return test::wall(10, 10, o); });
  count_composing();
  count_encoding();
  return 0;
}
