/// How fast the solvers are, all in one run, with the residuals they reach.
///
///     build/release/tests/qp_benchmark [--quick]
///
/// cold: nothing remembered but memory, so ordering and symbolic factors are part of it. warm:
/// twelve programs that each move the contacts by up to 1e-3 and turn every normal by up to 3e-4
/// rad, the mean of the last eleven. Best of several rounds.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <time.h>
#include <vector>

#include "core/qp/qp_solver.h"
#include "core/qp/residual_meter.h"
#include "tests/support/qp_zoo.h"

namespace {

using namespace wuerfel;
using test::ZooOptions;

constexpr int steps = 12;

/// CPU time of this thread, so that other work on the machine counts less.
double seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Timing {
  double cold = unbounded, warm = unbounded;  ///< s
  int cold_iterations = 0, warm_iterations = 0;
  double worst = 0.0;  ///< residual
  int failures = 0;
};

void check(const QpResult& result, Timing& timing) {
  timing.worst = std::max(timing.worst, result.residual.worst());
  if (result.status != QpStatus::optimal) ++timing.failures;
}

Timing measure(QpSolver& solver, const std::vector<QuadraticProgram>& programs, double budget) {
  Timing timing;
  QpResult result;
  const double start = seconds();
  const auto warm_steps = static_cast<double>(programs.size() - 1);
  // Small programs are solved several times between two looks at the clock.
  const int repeats = programs.front().rows() < 1000 && solver.name() != "ipopt" ? 8 : 1;
  for (int round = 0; round < 2 || (round < 2000 && seconds() - start < budget); ++round) {
    double t = seconds();
    for (int k = 0; k < repeats; ++k) {
      solver.forget();
      solver.solve(programs.front(), result);
    }
    timing.cold = std::min(timing.cold, (seconds() - t) / repeats);
    timing.cold_iterations = result.iterations;
    check(result, timing);
    timing.warm_iterations = 0;
    t = seconds();
    for (std::size_t k = 1; k < programs.size(); ++k) {
      solver.solve(programs[k], result);
      timing.warm_iterations += result.iterations;
      check(result, timing);
    }
    timing.warm = std::min(timing.warm, (seconds() - t) / warm_steps);
  }
  return timing;
}

void print_time(double s) {
  if (s < 1e-3) {
    std::printf(" %8.2f us", s * 1e6);
  } else {
    std::printf(" %8.2f ms", s * 1e3);
  }
}

struct Scene {
  std::string name;
  std::function<QuadraticProgram(const ZooOptions&)> build;
  ZooOptions options;
  bool with_ipopt;
  bool quick;
};

std::vector<QuadraticProgram> sequence(const Scene& scene) {
  std::vector<QuadraticProgram> programs;
  for (int step = 0; step < steps; ++step) {
    ZooOptions options = scene.options;
    options.step = static_cast<std::uint64_t>(step);
    programs.push_back(scene.build(options));
  }
  return programs;
}

void run(const Scene& scene, double budget) {
  const std::vector<QuadraticProgram> programs = sequence(scene);
  std::printf("%-22s %6d %6d", scene.name.c_str(), programs[0].blocks(), programs[0].rows());
  double ours = 0.0;
  for (const QpMethod method : {QpMethod::automatic, QpMethod::interior_point, QpMethod::ipopt}) {
    if (method == QpMethod::ipopt && !scene.with_ipopt) continue;
    const auto solver = make_qp_solver(method);
    const Timing timing = measure(*solver, programs, budget);
    std::printf(" | %s", std::string(to_string(method)).c_str());
    print_time(timing.cold);
    print_time(timing.warm);
    std::printf(" (%d, %.1f) %.0e%s", timing.cold_iterations,
                timing.warm_iterations / (steps - 1.0), timing.worst,
                timing.failures > 0 ? " MISSED" : "");
    if (method == QpMethod::automatic) ours = timing.warm;
    if (method == QpMethod::ipopt) std::printf(" = %.0f x", timing.warm / ours);
    std::fflush(stdout);
  }
  std::printf("\n");
}

/// The certificate of an old answer: is it still one?
void run_certificate() {
  const QuadraticProgram program = test::tower(1000);
  const auto solver = make_qp_solver(QpMethod::automatic);
  QpResult result;
  solver->solve(program, result);
  ResidualMeter meter;
  double best = unbounded;
  double worst = 0.0;
  for (int round = 0; round < 200; ++round) {
    const double t = seconds();
    meter.measure_scales(program);
    worst = meter.measure(program, result.x, result.multiplier).worst();
    best = std::min(best, seconds() - t);
  }
  std::printf("certificate of an old answer, tower 1000: %.1f ns per contact, residual %.0e\n",
              best * 1e9 / program.rows(), worst);
}

std::vector<Scene> scenes() {
  const ZooOptions moved{.shift = 1e-3, .turn = 3e-4};
  const ZooOptions ideal{};
  const ZooOptions alternating{
      .shift = 1e-3, .turn = 3e-4, .masses = test::Masses::alternating_1e6};
  const ZooOptions velocity{.shift = 1e-3, .turn = 3e-4, .velocity = true};
  const auto tower = [](int n) { return [n](const ZooOptions& o) { return test::tower(n, o); }; };
  const auto pile = [](int n) { return [n](const ZooOptions& o) { return test::pile(n, o); }; };
  const auto wall = [](int n) { return [n](const ZooOptions& o) { return test::wall(n, n, o); }; };
  const auto pyramid = [](int n) {
    return [n](const ZooOptions& o) { return test::pyramid(n, o); };
  };
  return {
      {"tower 1", tower(1), moved, true, true},
      {"tower 10", tower(10), moved, true, true},
      {"tower 100", tower(100), moved, true, true},
      {"tower 1000", tower(1000), moved, false, true},
      {"tower 30 masses 1e6", tower(30), alternating, true, true},
      {"pile 30", pile(30), moved, true, true},
      {"pile 100", pile(100), moved, true, true},
      {"pile 100 velocity", pile(100), velocity, false, true},
      {"pile 1000", pile(1000), moved, false, true},
      {"pile 3000", pile(3000), moved, false, false},
      {"pile 10000", pile(10000), moved, false, false},
      {"pyramid 40 at rest", pyramid(40), ideal, false, true},
      {"pyramid 100 at rest", pyramid(100), ideal, false, false},
      {"wall 10x10", wall(10), moved, false, true},
      {"wall 10x10 at rest", wall(10), ideal, false, true},
      {"wall 30x30", wall(30), moved, false, true},
      {"wall 30x30 at rest", wall(30), ideal, false, true},
      {"wall 60x60", wall(60), moved, false, false},
      {"wall 100x100", wall(100), moved, false, false},
      {"wall 100x100 at rest", wall(100), ideal, false, false},
  };
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::printf(
      "scene                  bodies   rows | method cold warm (factorisations) worst residual\n");
  for (const Scene& scene : scenes())
    if (scene.quick || !quick) run(scene, quick ? 0.2 : 1.0);
  run_certificate();
  return 0;
}
