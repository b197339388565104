#include "core/dynamics/missed_programs.h"

#include <utility>

namespace wuerfel {
namespace {

thread_local MissedProgramListener* listener =
    nullptr;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

}  // namespace

MissedProgramListener::MissedProgramListener(Hear hear) : hear_(std::move(hear)) {
  listener = this;
}

MissedProgramListener::~MissedProgramListener() { listener = nullptr; }

void MissedProgramListener::tell(const QuadraticProgram& program) {
  if (listener != nullptr) listener->hear_(program);
}

}  // namespace wuerfel
