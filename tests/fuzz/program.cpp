// Programs kept in files: read back equal, or refused; whatever is read can be solved.
#include "app/cli/exit_code.h"
#include "app/output/program_file.h"
#include "core/qp/qp_solver.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wuerfel;
  try {
    const QuadraticProgram program = parse_program(fuzz::text_of(data, size), "input");
    if (program.unknowns() > 60 || program.rows() > 60) return 0;
    fuzz::require(program_text(parse_program(program_text(program), "again"))
                  == program_text(program));
    QpResult result;
    make_qp_solver(QpMethod::automatic)->solve(program, result);
  } catch (const UsageError&) {
  }
  return 0;
}
