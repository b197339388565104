/// Quadratic programs as lines of JSON: those that a run could not solve as exactly as it was asked to,
/// kept so that they can be solved again. The keys are those of tests/data/qp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/output/text_output.h"
#include "core/qp/quadratic_program.h"

namespace wuerfel {

/// One line.
std::string program_text(const QuadraticProgram& program);

/// Throws UsageError that begins with `place`, where the text is none.
QuadraticProgram parse_program(std::string_view text, const std::string& place);

/// The file that failed programs go to; at most so many, for one that fails seldom fails alone.
class ProgramFile {
 public:
  static constexpr int most_programs = 100;

  /// Throws OutputError.
  explicit ProgramFile(const std::string& path) : file_(path) {}
  void add(const QuadraticProgram& program);
  /// The file appears, with nothing in it where nothing failed.
  void finish() { file_.finish(); }

 private:
  TextOutput file_;
  int programs_ = 0;
};

}  // namespace wuerfel
