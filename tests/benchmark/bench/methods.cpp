#include "tests/benchmark/bench/methods.h"

#include <array>

#include <fmt/core.h>

#include "app/cli/argument.h"
#include "app/cli/choice.h"

namespace wuerfel {

namespace {

constexpr std::size_t most_cubes_for_slow = 12;       // points, Ipopt
constexpr std::size_t most_cubes_for_stepping = 100;  // fixed steps that never rest

constexpr std::array tolerances{1e-4, 1e-6, 1e-8, 1e-10, 1e-12};
constexpr std::array steps{1.0 / 60, 1.0 / 240, 1.0 / 960, 1.0 / 3840};

constexpr double default_tolerance = 1e-8;

std::vector<std::string> parts(std::string_view text) {
  std::vector<std::string> list(1);
  for (const char c : text) {
    if (c == '/') {
      list.emplace_back();
    } else {
      list.back() += c;
    }
  }
  return list;
}

}  // namespace

std::string to_string(const BenchMethod& method) {
  return fmt::format("{}/{}/{}", to_string(method.integrator), to_string(method.formulation),
                     to_string(method.solver));
}

std::vector<BenchMethod> bench_methods() {
  using enum Integrator;
  using enum Formulation;
  std::vector<BenchMethod> methods;
  for (const Integrator integrator : {automatic, event, rattle, moreau, symplectic, euler})
    methods.push_back({integrator, rigid, QpMethod::automatic});
  for (const Integrator integrator : {symplectic, euler})
    methods.push_back({integrator, points, QpMethod::automatic});
  for (const QpMethod solver : {QpMethod::newton, QpMethod::interior_point, QpMethod::ipopt})
    methods.push_back({event, rigid, solver});
  methods.push_back({symplectic, rigid, QpMethod::ipopt});
  return methods;
}

std::vector<BenchMethod> parse_bench_methods(std::string_view text) {
  const std::vector<std::string> names = parts(text);
  if (names.size() > 3) {
    throw UsageError(fmt::format(
        "--methods: '{}' is not INTEGRATOR[/FORMULATION[/SOLVER]], such as event/rigid/newton",
        text));
  }
  BenchMethod named;
  named.integrator = parse_choice<Integrator>("--methods", names[0]);
  if (names.size() > 1) named.formulation = parse_choice<Formulation>("--methods", names[1]);
  if (names.size() > 2) {
    named.solver = parse_choice<QpMethod>("--methods", names[2]);
    return {named};
  }
  std::vector<BenchMethod> found;
  for (const BenchMethod& method : bench_methods()) {
    if (method.integrator != named.integrator) continue;
    if (names.size() == 1 || method.formulation == named.formulation) found.push_back(method);
  }
  if (found.empty()) found.push_back(named);
  return found;
}

bool has_tolerance(Integrator integrator) {
  return integrator == Integrator::automatic || integrator == Integrator::event;
}

bool suits(const BenchMethod& method, const BenchScene& scene) {
  const std::size_t cubes = scene.scene.cubes.size();
  if (method.formulation == Formulation::points || method.solver == QpMethod::ipopt)
    return cubes <= most_cubes_for_slow && (has_tolerance(method.integrator) || !scene.rests);
  if (method.solver == QpMethod::interior_point && cubes > most_cubes_for_stepping)
    return scene.name.starts_with("tower_");  // may find no rest where forces are not unique
  if (has_tolerance(method.integrator)) {
    return scene.rests || cubes <= most_cubes_for_slow
           || method.integrator == Integrator::automatic;
  }
  return cubes <= most_cubes_for_stepping;
}

std::vector<MotionSettings> bench_settings(const BenchMethod& method, const BenchScene& scene) {
  MotionSettings settings{.integrator = method.integrator,
                          .formulation = method.formulation,
                          .solver = method.solver,
                          .tolerance = default_tolerance};
  std::vector<MotionSettings> list;
  const bool sweep = !scene.rests && !scene.exact.empty();
  // Solvers differ in time, hardly in error: one setting tells that.
  const bool reference_solver = method.solver != QpMethod::automatic;
  if (reference_solver && !has_tolerance(method.integrator)) settings.step = steps.front();
  if (!sweep || reference_solver) return {settings};
  if (has_tolerance(method.integrator)) {
    for (const double tolerance : tolerances) {
      settings.tolerance = tolerance;
      list.push_back(settings);
    }
    return list;
  }
  for (const double step : steps) {
    settings.step = step;
    list.push_back(settings);
  }
  return list;
}

}  // namespace wuerfel
