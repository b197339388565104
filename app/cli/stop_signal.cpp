#include "app/cli/stop_signal.h"

#include "app/cli/memory_limit.h"

namespace wuerfel {

namespace {

// A signal handler can reach nothing but a global. NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t noted_signal = 0;

extern "C" void note_signal(int signal) { noted_signal = signal; }

}  // namespace

StopSignal::StopSignal(Ear ear) : ear_(ear) {
  if (ear_ == Ear::deaf) return;
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  for (std::size_t i = 0; i < handled.size(); ++i) {
    sigaction(handled[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) sigaction(handled[i], &action, nullptr);
  }
}

StopSignal::~StopSignal() {
  for (std::size_t i = 0; ear_ == Ear::open && i < handled.size(); ++i)
    sigaction(handled[i], &before_[i], nullptr);
}

void StopSignal::check() const {
  if (noted_signal != 0) throw Interrupted{noted_signal};
  check_memory();
}

}  // namespace wuerfel
