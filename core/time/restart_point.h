/// Instants at which a motion forgets: from there on it goes by what stands here alone, whether
/// somebody keeps it or not, so that a run that is taken up again has the bits of one that was not
/// interrupted.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/dynamics/momentum_balance.h"
#include "core/model/state.h"
#include "core/time/bookkeeping.h"
#include "core/time/state_hash.h"

namespace wuerfel {

/// Stepping of a group that would go on.
struct Stepping {
  double until = -1.0;  ///< s; in the past where there is none
  int patience = 1;     ///< frames that the next one lasts
};

struct RestartPoint {
  double t = 0.0;  ///< s
  State state;
  Bookkeeping book;
  StateHash hash;
  MomentumScale momentum;
  // Of motions in windows.
  double window = 0.0;  ///< s, length of the last one
  std::vector<char> resting;
  std::vector<Stepping> stepping;
  // Of motions in steps of one length.
  long steps = 0;
};

/// Told of every restart; the point is only made where somebody listens.
using RestartListener = std::function<void(const RestartPoint&)>;

/// Restarts come after so much work: steps, each times the cubes that move. Counts, not clocks: the
/// same scene restarts at the same instants. Solvers find out anew what they knew, which takes a few
/// steps' time.
inline constexpr long work_between_restarts = 50000;

/// Bytes that are no restart point.
class RestartError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// For the same build of the program on the same kind of machine.
std::string to_bytes(const RestartPoint& point);
/// Throws RestartError where the bytes are none of so many cubes.
RestartPoint restart_point_of(std::string_view bytes, std::size_t cubes);

std::string to_bytes(const std::vector<Contact>& contacts);
/// Throws RestartError where the bytes are none between so many bodies.
std::vector<Contact> contacts_of(std::string_view bytes, int bodies);

}  // namespace wuerfel
