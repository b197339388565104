/// How much memory the program holds, and may hold: what --max-memory says.
#pragma once

#include <stdexcept>

namespace wuerfel {

/// The program holds more than it may. Exit code 4, as where there is none at all.
class MemoryExceeded : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What is freed is kept for the next frame and the next solver. Handing megabytes back to the system in between takes
/// up to a fifth of the processor time of films and of large scenes.
void keep_freed_memory();

/// From now on, for the whole program: `bytes` of resident memory.
void limit_memory(double bytes);

/// Throws MemoryExceeded. Asks the system only once in a while, and not at all without a limit.
void check_memory();

}  // namespace wuerfel
