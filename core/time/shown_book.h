/// The book of a motion as it is at the time at which one looks, while groups are ahead of it.
#pragma once

#include <cstddef>

#include "core/time/bookkeeping.h"

namespace wuerfel {

/// What was lost up to some time, J.
struct LostEnergy {
  double impacts = 0.0;
  double friction = 0.0;
  double under_way = 0.0;  ///< in steps of which friction has taken a share only
};

class ShownBook {
 public:
  /// Goes on to t, which never falls; what is computed reaches at least up to there, in the order of time.
  void advance_to(double t, const Bookkeeping& computed);
  /// Losses up to the time of the last advance.
  [[nodiscard]] LostEnergy lost(const Bookkeeping& computed) const;
  [[nodiscard]] double time() const { return time_; }

  /// Events up to that time; what else a book holds is for the motion to fill in.
  Bookkeeping book;

 private:
  double time_ = 0.0;  ///< s
  std::size_t next_event_ = 0;
  std::size_t next_loss_ = 0;
  LostEnergy over_;  ///< of impacts, and of steps that are over
};

}  // namespace wuerfel
