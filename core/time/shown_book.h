/// The book of a motion as it is at the time at which one looks, while groups are ahead of it.
#pragma once

#include <cstddef>

#include "core/time/bookkeeping.h"

namespace wuerfel {

/// What was lost up to some time, J.
struct LostEnergy {
  double impacts = 0.0;
  double friction = 0.0;
};

class ShownBook {
 public:
  /// Goes on to t, which never falls; what is computed reaches at least up to there, in the order of time.
  void advance_to(double t, const Bookkeeping& computed);
  /// What is lost by the time of the last advance. `missing` J are gone by then: what is under way has taken of that what
  /// was not lost before, between nothing and all of its own.
  [[nodiscard]] LostEnergy lost(const Bookkeeping& computed, double missing) const;
  /// Whether the time of the last advance is in the midst of a step that loses energy.
  [[nodiscard]] bool any_under_way(const Bookkeeping& computed) const;

  /// Events up to that time; what else a book holds is for the motion to fill in.
  Bookkeeping book;

 private:
  [[nodiscard]] LostEnergy under_way(const Bookkeeping& computed) const;

  double time_ = 0.0;  ///< s
  std::size_t next_event_ = 0;
  std::size_t next_loss_ = 0;
  LostEnergy over_;
};

}  // namespace wuerfel
