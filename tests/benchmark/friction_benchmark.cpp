/// The exact solver beside the frictionless one on the same contacts, in one run: processor time
/// and residuals of the exact law.
///
///     build/release/tests/friction_benchmark [NAME]
///
/// cold: nothing remembered. warm: programs that each move the contacts by up to 1e-3 and turn every
/// normal by up to 3e-4 rad. Medians over mu = 0.1, 0.3, 0.6, 0.8, 1, 2. NAME: scenes that contain it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <time.h>
#include <vector>

#include "core/qp/coulomb/coulomb_solver.h"
#include "tests/support/friction_zoo.h"

namespace {

using namespace wuerfel;
using test::FrictionCase;
using test::FrictionOptions;

double seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Scene {
  std::string name;
  std::function<FrictionCase(const FrictionOptions&)> build;
  FrictionOptions options;
  double incline_share = 0.0;  ///< of atan mu
};

struct Sums {
  std::vector<double> qp_cold, qp_warm, cold, warm;
  std::map<std::string, int> cold_stages, warm_stages;
  double worst_cold = 0.0, worst_warm = 0.0;
  int crossings = 0, failures = 0, factorisations = 0;
};

double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.empty() ? 0.0 : v[v.size() / 2];
}

QuadraticProgram frictionless(const FrictionCase& c) {
  QuadraticProgram p;
  p.clear(3);
  p.mass = c.program.mass;
  p.target = c.program.target;
  for (const FrictionContact& contact : c.contacts) {
    p.add_inequality(c.program.bound[contact.normal]);
    for (int e = c.program.row_start[contact.normal]; e < c.program.row_start[contact.normal + 1];
         ++e)
      p.add_entry(c.program.entry_block[e], c.program.entry(e));
  }
  return p;
}

template <class F>
double best_of(int repeats, F&& run) {
  double best = unbounded;
  for (int k = 0; k < repeats; ++k) {
    const double t = seconds();
    run();
    best = std::min(best, seconds() - t);
  }
  return best;
}

void measure(const Scene& scene, double mu, Sums& sums) {
  constexpr int steps = 6;
  std::vector<FrictionCase> cases;
  std::vector<QuadraticProgram> plain;
  for (int step = 0; step < steps; ++step) {
    FrictionOptions options = scene.options;
    options.mu = mu;
    options.incline = std::tan(scene.incline_share * std::atan(mu));
    options.zoo.step = step;
    if (step > 0) {
      options.zoo.shift = std::max(options.zoo.shift, 1e-3);
      options.zoo.turn = std::max(options.zoo.turn, 3e-4);
    }
    cases.push_back(scene.build(options));
    plain.push_back(frictionless(cases.back()));
  }
  const int repeats = plain[0].rows() < 300 ? 20 : plain[0].rows() < 1000 ? 3 : 1;
  const auto qp = make_qp_solver(QpMethod::automatic);
  QpResult r;
  CoulombSolver solver;
  CoulombResult result;
  sums.qp_cold.push_back(best_of(repeats, [&] {
    qp->forget();
    qp->solve(plain[0], r);
  }));
  const FrictionProgram first = cases[0].view();
  sums.cold.push_back(best_of(repeats, [&] {
    solver.forget();
    solver.solve(first, result);
  }));
  const auto note = [&](std::map<std::string, int>& stages, double& worst) {
    ++stages[std::string(to_string(result.stage)) + (result.inexact() ? "!" : "")];
    worst = std::max(worst, coulomb_residual(first, result.x, result.multiplier).worst());
    sums.failures += result.inexact() ? 1 : 0;
    sums.crossings += result.crossings;
    sums.factorisations += result.factorisations;
  };
  note(sums.cold_stages, sums.worst_cold);
  for (int step = 1; step < steps; ++step) {
    sums.qp_warm.push_back(best_of(1, [&] { qp->solve(plain[step], r); }));
    const FrictionProgram next = cases[step].view();
    sums.warm.push_back(best_of(1, [&] { solver.solve(next, result); }));
    ++sums.warm_stages[std::string(to_string(result.stage)) + (result.inexact() ? "!" : "")];
    sums.worst_warm =
        std::max(sums.worst_warm, coulomb_residual(next, result.x, result.multiplier).worst());
    sums.failures += result.inexact() ? 1 : 0;
    sums.crossings += result.crossings;
  }
}

void run(const Scene& scene) {
  Sums sums;
  for (const double mu : {0.1, 0.3, 0.6, 0.8, 1.0, 2.0})
    measure(scene, mu, sums);
  const double us = 1e6;
  std::printf(
      "%-22s qp %8.1f/%8.1f exact %9.1f/%9.1f us (%5.1f /%5.1f) worst %.0e/%.0e failed %d "
      "crossings %d |",
      scene.name.c_str(), us * median(sums.qp_cold), us * median(sums.qp_warm),
      us * median(sums.cold), us * median(sums.warm), median(sums.cold) / median(sums.qp_cold),
      median(sums.warm) / median(sums.qp_warm), sums.worst_cold, sums.worst_warm, sums.failures,
      sums.crossings);
  for (const auto& [stage, count] : sums.cold_stages)
    std::printf(" %s %d", stage.c_str(), count);
  std::printf(" |");
  for (const auto& [stage, count] : sums.warm_stages)
    std::printf(" %s %d", stage.c_str(), count);
  std::printf("\n");
  std::fflush(stdout);
}

std::vector<Scene> scenes() {
  const auto tower = [](int n) {
    return [n](const FrictionOptions& o) { return test::friction_tower(n, o); };
  };
  const auto wall = [](int n) {
    return [n](const FrictionOptions& o) { return test::friction_wall(n, n, o); };
  };
  const auto pyramid = [](const FrictionOptions& o) { return test::friction_pyramid(40, o); };
  const auto dominoes = [](const FrictionOptions& o) { return test::friction_dominoes(40, o); };
  const auto pile = [](int n) {
    return [n](const FrictionOptions& o) { return test::friction_pile(n, o); };
  };
  const FrictionOptions rest{};
  const FrictionOptions punched{.punch = 3.0, .spin = 2.0};
  const FrictionOptions hit{.punch = 50.0, .spin = 20.0};
  const FrictionOptions tumbling{.tumble = true};
  const FrictionOptions heavy{.zoo = {.masses = test::Masses::alternating_1e6}};
  return {
      {"block slides", tower(1), punched},
      {"tower 5 rest", tower(5), rest},
      {"tower 5 punched", tower(5), punched},
      {"tower 10 rest", tower(10), rest},
      {"tower 10 incline 0.95", tower(10), rest, 0.95},
      {"tower 10 incline 1.05", tower(10), rest, 1.05},
      {"tower 10 punched", tower(10), punched},
      {"tower 30 rest", tower(30), rest},
      {"tower 30 incline 0.95", tower(30), rest, 0.95},
      {"tower 30 punched", tower(30), punched},
      {"tower 100 rest", tower(100), rest},
      {"tower 100 incline 0.95", tower(100), rest, 0.95},
      {"tower 100 punched", tower(100), punched},
      {"dominoes 40", dominoes, punched},
      {"tower 20 masses", tower(20), heavy},
      {"pile 30 rest", pile(30), rest},
      {"pile 30 tumbling", pile(30), tumbling},
      {"pile 100 rest", pile(100), rest},
      {"pile 100 tumbling", pile(100), tumbling},
      {"wall 10 rest", wall(10), rest},
      {"wall 10 punched", wall(10), punched},
      {"wall 10 hit", wall(10), hit},
      {"pile 1000 rest", pile(1000), rest},
      {"pyramid 40 rest", pyramid, rest},
      {"pyramid 40 punched", pyramid, punched},
      {"wall 30 rest", wall(30), rest},
      {"wall 30 punched", wall(30), punched},
      {"wall 30 hit", wall(30), hit},
  };
}

}  // namespace

int main(int argc, char** argv) {
  for (const Scene& scene : scenes())
    if (argc < 2 || scene.name.find(argv[1]) != std::string::npos) run(scene);
  return 0;
}
