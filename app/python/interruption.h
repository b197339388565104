/// Ctrl-C while C++ works.
#pragma once

#include <atomic>
#include <chrono>

namespace wuerfel::python {

/// Asks Python for signals, twenty times a second, from work that holds no GIL.
class Interruption {
 public:
  /// Throws pybind11::error_already_set (KeyboardInterrupt, mostly) where a handler raised, and in
  /// all other threads of the work something that ends them.
  void check();

 private:
  std::atomic<bool> stopped_ = false;
  std::atomic<std::chrono::steady_clock::rep> next_ = 0;
};

}  // namespace wuerfel::python
