#include <fstream>
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands/batch.h"
#include "app/commands/commands.h"
#include "app/output/program_file.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

struct ReplayOptions {
  std::string file;
  bool json = false;
};

constexpr QpMethod methods[] = {QpMethod::automatic, QpMethod::newton, QpMethod::interior_point,
                                QpMethod::ipopt};

Json answer_of(QpMethod method, const QuadraticProgram& program) {
  QpResult result;
  make_qp_solver(method)->solve(program, result);
  return {{"solver", to_string(method)},
          {"status", to_string(result.status)},
          {"residual", result.residual.worst()},
          {"iterations", result.iterations}};
}

Json replayed(const QuadraticProgram& program, int number) {
  Json answers = Json::array();
  for (const QpMethod method : methods)
    answers.push_back(answer_of(method, program));
  return {{"program", number},
          {"unknowns", program.unknowns()},
          {"rows", program.rows()},
          {"answers", std::move(answers)}};
}

std::string text_of(const Json& replay) {
  std::string text = fmt::format("program {}: {} unknowns, {} rows\n", replay["program"].get<int>(),
                                 replay["unknowns"].get<int>(), replay["rows"].get<int>());
  for (const Json& answer : replay["answers"]) {
    text += fmt::format("  {:<16} {:<12} residual {:<10.3g} {} iterations\n",
                        answer["solver"].get<std::string>(), answer["status"].get<std::string>(),
                        answer["residual"].is_null() ? 0.0 : answer["residual"].get<double>(),
                        answer["iterations"].get<int>());
  }
  return text;
}

// One program a line: whether each is solved now by the solver that runs use.
ExitCode replay(const ReplayOptions& asked) {
  std::ifstream file(asked.file, std::ios::binary);
  if (!file) throw UsageError(fmt::format("there is no {}", asked.file));
  bool solved = true;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    const std::string place = fmt::format("{}:{}", asked.file, ++number);
    const Json answer = replayed(parse_program(line, place), number);
    solved = solved && answer["answers"][0]["status"] == to_string(QpStatus::optimal);
    write_text("-", asked.json ? answer.dump() + "\n" : text_of(answer));
  }
  return solved ? ExitCode::fine : ExitCode::undecided;
}

}  // namespace

Action declare_replay(Options& options) {
  auto asked = std::make_shared<ReplayOptions>();
  options.argument("FILE", "programs that `run --failed-programs` wrote", asked->file);
  options.flag("--json", "print each answer as a line of JSON", asked->json);
  return [asked](const Stopwatch&) { return replay(*asked); };
}

}  // namespace wuerfel
