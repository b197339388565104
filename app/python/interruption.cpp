#include "app/python/interruption.h"

#include <pybind11/pybind11.h>
#include <stdexcept>

namespace wuerfel::python {

namespace py = pybind11;

void Interruption::check() {
  using Clock = std::chrono::steady_clock;
  constexpr auto pause = std::chrono::duration_cast<Clock::duration>(std::chrono::milliseconds(50));
  if (stopped_) throw std::runtime_error("interrupted");
  const Clock::rep now = Clock::now().time_since_epoch().count();
  Clock::rep due = next_;
  if (now < due || !next_.compare_exchange_strong(due, now + pause.count())) return;
  const py::gil_scoped_acquire python;
  if (PyErr_CheckSignals() == 0) return;  // of the main thread; in others it is none of ours
  stopped_ = true;
  throw py::error_already_set();
}

}  // namespace wuerfel::python
