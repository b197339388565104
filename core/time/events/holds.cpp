#include "core/time/events/holds.h"

#include <algorithm>
#include <limits>

namespace wuerfel {
namespace {

/// A force has left zero where it is this many times what counts as zero.
constexpr double armed_times = 3.0;
/// Overlaps of flush sides shorter than this share of a side have one end.
constexpr double no_overlap = 1e-10;

}  // namespace

void Holds::begin(const ClosedContacts& closed, double zero) {
  zero_ = zero;
  holds_.clear();
  const std::vector<Contact>& contacts = closed.contacts();
  for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
    const Contact& c = contacts[k];
    Hold hold;
    hold.first = k;
    if (system_->body(c.from).kind != BodyKind::plane
        && k + 1 < static_cast<int>(contacts.size())) {
      const Contact& d = contacts[k + 1];
      if (d.on == c.on && d.from == c.from) hold.second = ++k;
    }
    const std::array<double, 2> force = forces(closed, hold);
    for (std::size_t end = 0; end < 2; ++end) {
      if (force[end] <= armed_times * zero) hold.offset[end] = zero + std::max(0.0, -force[end]);
    }
    holds_.push_back(hold);
  }
}

/// The forces on the corners of a flush pair's rows are moved to the ends of the overlap by the law
/// of the lever.
std::array<double, 2> Holds::forces(const ClosedContacts& closed, const Hold& hold) {
  const auto first = static_cast<std::size_t>(hold.first);
  const double f = closed.forces()[first];
  if (hold.second < 0) return {f, f};
  const auto second = static_cast<std::size_t>(hold.second);
  const double g = closed.forces()[second];
  const Contact& c = closed.contacts()[first];
  const double s_1 = c.alpha * c.length;
  const double s_2 = closed.contacts()[second].alpha * c.length;
  const double low = std::max(0.0, std::min(s_1, s_2));
  const double high = std::min(c.length, std::max(s_1, s_2));
  if (high - low <= no_overlap * c.length) return {f + g, f + g};
  const double moment = f * s_1 + g * s_2;
  return {((f + g) * high - moment) / (high - low), (moment - (f + g) * low) / (high - low)};
}

double Holds::smallest(const ClosedContacts& closed) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Hold& hold : holds_) {
    const std::array<double, 2> force = forces(closed, hold);
    least = std::min({least, force[0] + hold.offset[0], force[1] + hold.offset[1]});
  }
  return least;
}

void Holds::arm(const ClosedContacts& closed) {
  for (Hold& hold : holds_) {
    const std::array<double, 2> force = forces(closed, hold);
    for (std::size_t end = 0; end < 2; ++end) {
      if (force[end] > armed_times * zero_) hold.offset[end] = 0.0;
    }
  }
}

}  // namespace wuerfel
