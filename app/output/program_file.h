/// Quadratic programs as lines of JSON: those that a run could not solve as exactly as it was asked to,
/// kept so that they can be solved again. The keys are those of tests/data/qp, and where something rubs
/// "contacts": [normal row of J, tangential row of E or -1, mu, known direction of slip or 0].
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/output/text_output.h"
#include "core/qp/coulomb/friction_program.h"

namespace wuerfel {

struct KeptProgram {
  QuadraticProgram program;
  std::vector<FrictionContact> contacts;  ///< none where nothing rubs
  [[nodiscard]] FrictionProgram view() const { return {program, contacts}; }
};

/// One line.
std::string program_text(const FrictionProgram& friction);

/// Throws UsageError that begins with `place`, where the text is none.
KeptProgram parse_program(std::string_view text, const std::string& place);

/// The file that failed programs go to; at most so many, for one that fails seldom fails alone.
class ProgramFile {
 public:
  static constexpr int most_programs = 100;

  /// Throws OutputError.
  explicit ProgramFile(const std::string& path) : file_(path) {}
  void add(const FrictionProgram& program);
  /// The file appears, with nothing in it where nothing failed.
  void finish() { file_.finish(); }

 private:
  TextOutput file_;
  int programs_ = 0;
};

}  // namespace wuerfel
