#include "core/qp/coulomb/proximal_path.h"

#include <algorithm>
#include <cmath>

namespace wuerfel {
namespace {

constexpr double least_delta = 3e-8;  ///< below it K has lost its digits: G' l differs from y
constexpr double most_delta = 0.1;
constexpr double compliance_fall = 0.5;
constexpr double compliance_rise = 4.0;  ///< where a path is lost
constexpr double nearer = 0.8;  ///< of what rows miss that a step leaves, for compliance to shrink
constexpr double same_way = 0.9;  ///< cosine between steps that go on
constexpr double times_growth = 3.0;
constexpr double most_times = 1e5;
constexpr double cone_margin = 1e-9;
constexpr double slip_margin = 1e-4;  ///< times the compliance
constexpr double farthest = 3.0;      ///< t of paths that are lost
constexpr int most_lost = 100;
constexpr int crossings_of_path = 200;  ///< at most, and one more for so many units
constexpr int units_per_crossing = 8;

double product(const std::vector<Pair>& a, const std::vector<Pair>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i].n * b[i].n + a[i].t * b[i].t;
  return sum;
}

/// to += factor what
void add(double factor, const std::vector<Pair>& what, std::vector<Pair>& to) {
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = {to[i].n + factor * what[i].n, to[i].t + factor * what[i].t};
}

}  // namespace

void ProximalPath::begin(const ContactPoint& point, const ProximalPathEffort& effort) {
  effort_ = effort;
  delta_ = effort.delta;
  times_ = 0.0;
  former_ = unbounded;
  centre_ = point.l;
  way_.clear();
  paths_ = lost_ = crossings_ = 0;
}

bool ProximalPath::step(ContactForm& form, std::vector<ContactMode>& modes, ContactPoint& point) {
  while (lost_ <= most_lost && paths_ + crossings_ < effort_.most_crossings) {
    const std::vector<ContactMode> kept_modes = modes;
    const ContactPoint kept_point = point;
    if (arrives(form, modes, point)) {
      choose_next(form, missed_by(form, modes, point), point);
      return true;
    }
    modes = kept_modes;
    point = kept_point;
    step_back(point);
  }
  return false;
}

bool ProximalPath::arrives(ContactForm& form,
                           std::vector<ContactMode>& modes,
                           ContactPoint& point) {
  const ModePathOutcome outcome =
      path_.run(form, modes, point, centre_, static_cast<std::uint64_t>(++paths_),
                {.delta = delta_,
                 .most_crossings = crossings_of_path + form.count() / units_per_crossing,
                 .margin = cone_margin,
                 .velocity_margin = slip_margin * delta_,
                 .farthest = farthest});
  crossings_ += outcome.crossings;
  return outcome.arrived;
}

/// After a path that was lost: a shorter step, or a softer one.
void ProximalPath::step_back(const ContactPoint& point) {
  ++lost_;
  if (times_ == 0.0) delta_ = std::min(compliance_rise * delta_, most_delta);
  times_ = 0.0;
  former_ = unbounded;
  centre_ = point.l;
  way_.clear();
}

/// Whether forces move the same way as in the step before.
bool ProximalPath::goes_on(const std::vector<Pair>& way) const {
  if (way_.empty()) return false;
  return product(way, way_) > same_way * std::sqrt(product(way, way) * product(way_, way_));
}

void ProximalPath::choose_next(const ContactForm& form, double missed, const ContactPoint& point) {
  std::vector<Pair> way = point.l;
  add(-1.0, centre_, way);
  times_ = goes_on(way) ? std::min(times_growth * times_ + 1.0, most_times) : 0.0;
  if (missed < nearer * former_ && delta_ > least_delta) {
    delta_ = std::max(compliance_fall * delta_, least_delta);
    times_ = 0.0;
  }
  former_ = missed;
  centre_ = point.l;
  if (times_ > 0.0)
    add(std::min(times_, effort_.most_force / largest_force(form, way)), way, centre_);
  way_ = std::move(way);
}

}  // namespace wuerfel
