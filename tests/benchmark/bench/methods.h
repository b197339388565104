/// Which methods `bench` measures, with which tolerances or steps, on which scenes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/settings.h"
#include "tests/benchmark/bench/scenes.h"

namespace wuerfel {

struct BenchMethod {
  Integrator integrator = Integrator::automatic;
  Formulation formulation = Formulation::rigid;
  QpMethod solver = QpMethod::automatic;
};

/// "event/rigid/auto".
std::string to_string(const BenchMethod& method);

/// All that make sense.
std::vector<BenchMethod> bench_methods();

/// "event", "event/points" or "event/rigid/newton": those of bench_methods() that begin so, or the
/// one named in full. Throws UsageError.
std::vector<BenchMethod> parse_bench_methods(std::string_view text);

/// Steered by a tolerance, not by a step.
bool has_tolerance(Integrator integrator);

/// Point formulations, slow solvers and first-order steps are kept away from scenes where they
/// would take minutes.
bool suits(const BenchMethod& method, const BenchScene& scene);

/// The settings to run, from coarse to fine.
std::vector<MotionSettings> bench_settings(const BenchMethod& method, const BenchScene& scene);

}  // namespace wuerfel
