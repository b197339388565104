/// Bouncing, and rocking, come to rest in finite time by impacts without end: intervals between them
/// fall like a geometric series, whose sum says when [Brogliato 1999, ch. 5].
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/time/bookkeeping.h"

namespace wuerfel {

class BounceSeries {
 public:
  using NamePair = std::pair<std::string, std::string>;
  using Stays = std::function<bool(const NamePair&)>;

  /// Takes note of the impacts of an instant. A rest that ends a series, short of its last bounces,
  /// at this instant or a later one, is dated when these would be over, if that is within `most` s;
  /// pairs that stay in touch and move on, which `stays` knows (names in order), get the event
  /// `touch` at that time.
  void note(std::vector<Event>& events, const Stays& stays, double most);
  /// Whether the impacts of the last instant went on with their series.
  [[nodiscard]] bool goes_on() const { return goes_on_; }

 private:
  struct Series {
    double last = 0.0;      ///< s, the last impact
    double interval = 0.0;  ///< s, before it; 0: none
    double ratio = 0.0;     ///< of the last two intervals
    int agreeing = 0;       ///< ratios in a row
    double end = 0.0;  ///< s, when it would be over, by the last ratios that agreed; 0: they don't
    void add(double t);
    [[nodiscard]] bool converges() const { return end > last; }
  };
  void date_touches(std::vector<Event>& events, const Stays& stays, double most) const;
  void date_rests(std::vector<Event>& events, double most) const;

  std::map<NamePair, Series> of_pair_;
  bool goes_on_ = false;
};

}  // namespace wuerfel
