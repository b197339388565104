/// One measurement of `bench`, and the table of them as CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wuerfel {

struct BenchRow {
  std::string scene;
  std::size_t bodies = 0;
  std::string engine;  ///< "wuerfel", or a peer with its version
  std::string method;  ///< integrator/formulation/solver, or a peer's configuration
  std::optional<double> tolerance;
  std::optional<double> step;  ///< s
  double simulated = 0.0;      ///< s
  long repeats = 0;
  double cpu = 0.0;                    ///< s, least of the repeats: made, moved, taken down
  double cpu_setup = 0.0;              ///< s, the share of making and taking down
  std::optional<double> state_error;   ///< see state_error in bench_scenes.h
  std::optional<double> place_error;   ///< the same of positions and angles alone
  std::optional<double> event_error;   ///< s
  std::optional<double> overlap;       ///< m, deepest at any step end
  std::optional<double> energy_drift;  ///< J, not explained by impacts
  std::optional<double> residual;      ///< worst optimality residual of any program used
  long steps = 0;
  long solves = 0;
  long skips = 0;
  std::string status = "ok";  ///< or what went wrong, in words
};

/// What the figures depend on: machine, compiler and program.
struct BenchMachine {
  std::string cpu;
  std::string compiler;
  std::string version;
  std::string commit;  ///< see commit.h
};

/// The machine this runs on.
BenchMachine this_machine();

/// Head and one line per row; empty fields where a figure does not exist.
std::string bench_csv(const std::vector<BenchRow>& rows, const BenchMachine& machine);

/// The same for people: fewer columns, aligned.
std::string bench_table(const std::vector<BenchRow>& rows, const BenchMachine& machine);

/// "tolerance 1e-08", "step 1/240 s" or nothing.
std::string setting_text(const BenchRow& row);

}  // namespace wuerfel
