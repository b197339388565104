// Programs kept in files: read back equal, or refused; whatever is read can be solved.
#include "app/cli/exit_code.h"
#include "app/output/program_file.h"
#include "core/qp/coulomb/coulomb_solver.h"
#include "core/qp/qp_solver.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wuerfel;
  try {
    const KeptProgram kept = parse_program(fuzz::text_of(data, size), "input");
    if (kept.program.unknowns() > 60 || kept.program.rows() > 60) return 0;
    const std::string text = program_text(kept.view());
    fuzz::require(program_text(parse_program(text, "again").view()) == text);
    if (kept.contacts.empty()) {
      QpResult result;
      make_qp_solver(QpMethod::automatic)->solve(kept.program, result);
    } else {
      CoulombResult result;
      CoulombSolver().solve(kept.view(), result);
    }
  } catch (const UsageError&) {
  }
  return 0;
}
