#include "app/cli/memory_limit.h"

#include <atomic>
#include <cstdio>
#include <malloc.h>
#include <unistd.h>

#include <fmt/core.h>

namespace wuerfel {

namespace {

constexpr double megabyte = 1e6;
constexpr int calls_per_look = 16;  // a look takes some microseconds

// One limit for one program.
std::atomic<double> limit = 0.0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::atomic<int> calls = 0;       // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// Bytes; 0 where the system does not tell.
double resident_memory() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return 0.0;
  double all = 0.0;
  double resident = 0.0;
  const bool read = std::fscanf(file, "%lf %lf", &all, &resident) == 2;  // NOLINT(cert-err34-c)
  static_cast<void>(std::fclose(file));
  return read ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0.0;
}

}  // namespace

void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD
  constexpr int kept = 256 << 20;  // bytes
  static_cast<void>(mallopt(M_TRIM_THRESHOLD, kept));
  static_cast<void>(mallopt(M_MMAP_THRESHOLD, kept));
#endif
}

void limit_memory(double bytes) { limit = bytes; }

void check_memory() {
  if (limit == 0.0 || calls++ % calls_per_look != 0) return;
  const double held = resident_memory();
  if (held <= limit) return;
  throw MemoryExceeded(
      fmt::format("out of memory: {:.0f} MB are held, --max-memory allows {:.0f} MB",
                  held / megabyte, limit / megabyte));
}

}  // namespace wuerfel
