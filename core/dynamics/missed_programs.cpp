#include "core/dynamics/missed_programs.h"

#include <utility>

namespace wuerfel {
namespace {

// Whoever measures hears of it in his own thread.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
thread_local MissedProgramListener* listener = nullptr;

}  // namespace

MissedProgramListener::MissedProgramListener(Hear hear) : hear_(std::move(hear)) {
  listener = this;
}

MissedProgramListener::~MissedProgramListener() { listener = nullptr; }

void MissedProgramListener::tell(const FrictionProgram& program) {
  if (listener != nullptr) listener->hear_(program);
}

}  // namespace wuerfel
