#include "app/output/replay.h"

#include <fstream>

#include <fmt/core.h>

#include "app/cli/exit_code.h"
#include "app/output/program_file.h"
#include "core/qp/coulomb/coulomb_solver.h"
#include "core/qp/qp_solver.h"
#include "render/files/file_bytes.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

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

/// What rubs has one solver.
Json answer_of(const FrictionProgram& friction) {
  CoulombResult result;
  CoulombSolver().solve(friction, result);
  return {{"solver", "coulomb"},
          {"status", to_string(result.status)},
          {"residual", result.residual.worst()},
          {"iterations", result.factorisations + result.crossings}};
}

Json replayed(const KeptProgram& kept, int number) {
  const QuadraticProgram& program = kept.program;
  Json answers = Json::array();
  if (kept.contacts.empty()) {
    for (const QpMethod method : methods)
      answers.push_back(answer_of(method, program));
  } else {
    answers.push_back(answer_of(kept.view()));
  }
  return {{"program", number},
          {"unknowns", program.unknowns()},
          {"rows", program.rows()},
          {"answers", std::move(answers)}};
}

}  // namespace

void replay_programs(const std::string& path, const std::function<void(const Json&)>& show) {
  std::ifstream file = open_to_read(path);
  int number = 0;
  for (std::string line; file.peek() != std::ifstream::traits_type::eof();) {
    const std::string place = fmt::format("{}:{}", path, ++number);
    // A device without end has no lines either.
    if (file.peek() != '{') throw UsageError(place + ": no program: it does not begin with {");
    std::getline(file, line);
    show(replayed(parse_program(line, place), number));
  }
}

}  // namespace wuerfel
