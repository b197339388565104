#include "app/cli/stopwatch.h"

#include <ctime>
#include <sys/resource.h>

#include "render/files/child_process.h"

namespace wuerfel {

namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Not that of getrusage, which may count in ticks of 4 ms.
double cpu_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double cpu_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double cpu_seconds(Stopwatch::Of whom) {
  if (whom == Stopwatch::Of::thread)
    return cpu_of(CLOCK_THREAD_CPUTIME_ID) + cpu_of_children_of_thread();
  return cpu_of(CLOCK_PROCESS_CPUTIME_ID) + cpu_of_children();
}

}  // namespace

Stopwatch::Stopwatch(Of whom)
    : whom_(whom), wall_start_(std::chrono::steady_clock::now()), cpu_start_(cpu_seconds(whom)) {}

double Stopwatch::wall() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start_).count();
}

double Stopwatch::cpu() const { return cpu_seconds(whom_) - cpu_start_; }

}  // namespace wuerfel
