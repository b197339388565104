/// What went wrong, as a sentence and an exit code: one code for one cause, whatever the command.
#pragma once

#include <exception>
#include <string>

#include "app/cli/exit_code.h"

namespace wuerfel {

struct Failure {
  std::string message;
  ExitCode code = ExitCode::internal;
};

/// Of anything that was thrown but Interrupted, which goes on its way.
Failure failure_of(const std::exception_ptr& thrown);

/// "wuerfel: message" on standard error.
void complain(const std::string& message);

}  // namespace wuerfel
