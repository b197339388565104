#include "app/cli/stopwatch.h"

#include <sys/resource.h>

namespace wuerfel {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double cpu_of(decltype(RUSAGE_SELF) who) {
  rusage usage{};
  getrusage(who, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double cpu_seconds(Stopwatch::Of whom) {
  if (whom == Stopwatch::Of::thread) return cpu_of(RUSAGE_THREAD);
  return cpu_of(RUSAGE_SELF) + cpu_of(RUSAGE_CHILDREN);
}

}  // namespace

Stopwatch::Stopwatch(Of whom)
    : whom_(whom), wall_start_(std::chrono::steady_clock::now()), cpu_start_(cpu_seconds(whom)) {}

double Stopwatch::wall() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start_).count();
}

double Stopwatch::cpu() const { return cpu_seconds(whom_) - cpu_start_; }

}  // namespace wuerfel
