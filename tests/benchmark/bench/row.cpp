#include "tests/benchmark/bench/row.h"

#include <cmath>
#include <fstream>

#include <fmt/core.h>

#include "tests/benchmark/bench/commit.h"

namespace wuerfel {

namespace {

std::string number(double value) { return fmt::format("{:.6g}", value); }

std::string number(const std::optional<double>& value) {
  return value ? number(*value) : std::string{};
}

// A field of CSV: quoted where it has to be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string brief(const std::optional<double>& value) {
  return value ? fmt::format("{:.1e}", *value) : std::string("-");
}

std::string time_text(double s) {
  if (s < 1e-3) return fmt::format("{:.1f} us", s * 1e6);
  if (s < 1.0) return fmt::format("{:.2f} ms", s * 1e3);
  return fmt::format("{:.2f} s", s);
}

}  // namespace

BenchMachine this_machine() {
  std::string cpu = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  int cores = 0;
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    ++cores;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) cpu = line.substr(colon + 2);
  }
  return {fmt::format("{} ({} cores)", cpu, cores), fmt::format("GCC {}", __VERSION__),
          WUERFEL_VERSION, std::string(commit())};
}

std::string bench_csv(const std::vector<BenchRow>& rows, const BenchMachine& machine) {
  std::string text =
      "scene,bodies,engine,method,tolerance,step,simulated_s,repeats,cpu_s,cpu_setup_s,state_error,"
      "place_error,"
      "event_error_s,overlap_m,energy_drift_J,residual,steps,solves,skips,status,machine,compiler,"
      "version,commit\n";
  for (const BenchRow& row : rows) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},", field(row.scene), row.bodies,
                        field(row.engine), field(row.method), number(row.tolerance),
                        number(row.step), number(row.simulated), row.repeats,
                        row.repeats > 0 ? number(row.cpu) : std::string{}, number(row.cpu_setup));
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", number(row.state_error),
                        number(row.place_error), number(row.event_error), number(row.overlap),
                        number(row.energy_drift), number(row.residual), row.steps, row.solves,
                        row.skips, field(row.status), field(machine.cpu), field(machine.compiler),
                        field(machine.version), field(machine.commit));
  }
  return text;
}

std::string bench_table(const std::vector<BenchRow>& rows, const BenchMachine& machine) {
  std::string text = fmt::format("wuerfel {} (commit {}), {}, {}\n\n", machine.version,
                                 machine.commit, machine.compiler, machine.cpu);
  text += fmt::format("{:<18} {:<34} {:<18} {:>10} {:>9} {:>9} {:>9} {:>9} {:>8}  {}\n", "scene",
                      "method", "", "CPU time", "state err", "event / s", "overlap/m", "drift / J",
                      "steps", "status");
  for (const BenchRow& row : rows) {
    const std::string method =
        row.engine == "wuerfel" ? row.method : fmt::format("{} {}", row.engine, row.method);
    text += fmt::format(
        "{:<18} {:<34} {:<18} {:>10} {:>9} {:>9} {:>9} {:>9} {:>8}  {}\n", row.scene, method,
        setting_text(row), row.repeats > 0 ? time_text(row.cpu) : "-", brief(row.state_error),
        brief(row.event_error), brief(row.overlap), brief(row.energy_drift), row.steps, row.status);
  }
  return text;
}

std::string setting_text(const BenchRow& row) {
  if (row.tolerance) return fmt::format("tolerance {:.0e}", *row.tolerance);
  if (row.step) return fmt::format("step 1/{:.0f} s", 1.0 / *row.step);
  return {};
}

}  // namespace wuerfel
