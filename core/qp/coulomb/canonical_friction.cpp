#include "core/qp/coulomb/canonical_friction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/qp/coulomb/dice.h"
#include "core/qp/coulomb/nearest_forces.h"

namespace wuerfel {
namespace {

constexpr double same_force = 1e-7;  ///< of the largest
constexpr double same_row = 1e-9;
/// Of the largest force: wishes of other ones, each with its opposite.
constexpr std::array wish_sizes{1.0, 1000.0};
constexpr double far_along = 1e3;      ///< times mu: the share of tangential wishes, at most 1
constexpr double certain_times = 1e3;  ///< what a wish misses, that counts as moved
constexpr int most_pushes = 8;

/// Whether tangential forces of two units act alike: both are of the same flush sides.
bool act_alike(const ContactForm& form, const ContactUnit& a, const ContactUnit& b) {
  const int size = a.last - a.first;
  if (size != b.last - b.first
      || !std::equal(form.blocks_of(a), form.blocks_of(a) + size, form.blocks_of(b)))
    return false;
  double apart = 0.0;
  for (int e = 0; e < size; ++e) {
    for (int c = 0; c < 3; ++c) {
      const double d = form.entries(a)[e].t.v[c] - form.entries(b)[e].t.v[c];
      apart += d * d;
    }
  }
  return apart <= same_row * same_row * a.square.t;
}

/// Per unit the first one whose tangential force acts as its own.
std::vector<int> first_alike(const ContactForm& form) {
  std::vector<int> first(form.count());
  std::multimap<int, int> of_block;  // by first blocks
  for (int i = 0; i < form.count(); ++i) {
    const ContactUnit& unit = form.units()[i];
    first[i] = i;
    if (unit.tangent < 0) continue;
    const auto [begin, end] = of_block.equal_range(*form.blocks_of(unit));
    const auto same = std::find_if(
        begin, end, [&](const auto& k) { return act_alike(form, form.units()[k.second], unit); });
    if (same == end) {
      of_block.emplace(*form.blocks_of(unit), i);
    } else {
      first[i] = same->second;
    }
  }
  return first;
}

/// Of flush sides only the sum of tangential forces is one: it is put to the first of them.
std::vector<Pair> with_sums(std::vector<Pair> l, const std::vector<int>& first) {
  for (std::size_t i = 0; i < l.size(); ++i)
    if (first[i] != static_cast<int>(i)) l[first[i]].t += l[i].t;
  for (std::size_t i = 0; i < l.size(); ++i)
    l[i].t = l[first[i]].t;
  return l;
}

/// From forces on a face of the cone of unit i into it; nothing from its inside.
Pair inward(const ForceProblem& p, int i, const Pair& l, double least) {
  if (p.cone[i] == Cone::nothing || p.cone[i] == Cone::free) return {};
  if (l.n <= least) return {1.0, 0.0};
  const double mu = p.form.units()[i].mu;
  if (p.cone[i] != Cone::cone || mu * l.n - std::abs(l.t) > least) return {};
  const double size = std::sqrt(1.0 + mu * mu);
  return {mu / size, std::copysign(1.0, -l.t) / size};
}

/// Which forces are the only ones possible: those that wishes of other ones do not move. Wishes end on faces of what is
/// possible, from which few others move; so the middle of what they found is pushed off all faces that it can leave.
class UniqueForces {
 public:
  UniqueForces(ForceProblem& p, const std::vector<Pair>& least)
      : p_(&p),
        first_(first_alike(p.form)),
        canonical_(with_sums(least, first_)),
        middle_(least),
        unique_(least.size(), true),
        dice_(least.size()) {
    for (const Pair& l : canonical_)
      force_ = std::max({force_, std::abs(l.n), std::abs(l.t)});
    if (force_ == 0.0) force_ = 1.0;  // what is braced presses as hard as it likes
    searched_ = !is_open();
  }

  std::vector<bool> find() {
    const std::vector<Pair> nothing(middle_.size());
    for (const double size : wish_sizes)
      if (is_open()) wish_both_ways(nothing, size * force_);
    for (int k = 0; k < most_pushes && is_open() && push(); ++k) {
    }
    if (is_open()) wish_both_ways(middle_, force_);
    if (!searched_) unique_.assign(unique_.size(), false);
    return unique_;
  }

 private:
  /// Whether any unit whose force is the only one so far may carry something.
  [[nodiscard]] bool is_open() const {
    for (std::size_t i = 0; i < unique_.size(); ++i)
      if (unique_[i] && p_->cone[i] != Cone::nothing) return true;
    return false;
  }

  void wish_both_ways(const std::vector<Pair>& from, double size) {
    std::vector<Pair> there = from;
    std::vector<Pair> back = from;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const double along = std::min(1.0, far_along * p_->form.units()[i].mu);
      const Pair w{size * (2.0 * dice_.next() - 1.0), along * size * (2.0 * dice_.next() - 1.0)};
      there[i] = {from[i].n + w.n, from[i].t + w.t};
      back[i] = {from[i].n - w.n, from[i].t - w.t};
    }
    (void)wish(there);
    (void)wish(back);
  }

  /// Whether the middle has left a face.
  bool push() {
    std::vector<Pair> pushed = middle_;
    std::vector<char> on_face(middle_.size(), 0);
    for (int i = 0; i < p_->form.count(); ++i) {
      const Pair in = inward(*p_, i, middle_[i], least());
      pushed[i].n += force_ * in.n;
      pushed[i].t += force_ * in.t;
      on_face[i] = in.n != 0.0 ? 1 : 0;
    }
    if (std::ranges::count(on_face, 1) == 0 || !wish(pushed)) return false;
    for (int i = 0; i < p_->form.count(); ++i)
      if (on_face[i] != 0 && inward(*p_, i, middle_[i], least()).n == 0.0) return true;
    return false;
  }

  /// Forces that are away from the canonical ones are not the only ones. Whether the wish was granted.
  bool wish(const std::vector<Pair>& wish) {
    const NearestForces other = nearest(*p_, wish);
    if (other.misfit > good_balance) return false;
    searched_ = true;
    const double moved = std::max(least(), certain_times * other.misfit * force_);
    const std::vector<Pair> l = with_sums(other.l, first_);
    for (std::size_t i = 0; i < l.size(); ++i) {
      const Pair& c = canonical_[i];
      if (std::max(std::abs(l[i].n - c.n), std::abs(l[i].t - c.t)) > moved) unique_[i] = false;
      middle_[i] = {0.5 * (middle_[i].n + other.l[i].n), 0.5 * (middle_[i].t + other.l[i].t)};
    }
    return true;
  }

  [[nodiscard]] double least() const { return same_force * force_; }  ///< that counts, N

  ForceProblem* p_;
  std::vector<int> first_;
  std::vector<Pair> canonical_;
  std::vector<Pair> middle_;
  std::vector<bool> unique_;
  Dice dice_;
  double force_ = 0.0;  ///< the largest, N
  bool searched_ = false;
};

}  // namespace

CanonicalForces canonical_friction(const FrictionProgram& friction,
                                   const std::vector<double>& x,
                                   const std::vector<double>& multiplier,
                                   bool with_unique) {
  ForceProblem p = problem_of(friction, x, multiplier);
  const NearestForces least = nearest(p, std::vector<Pair>(p.form.count()));
  CanonicalForces result{multiplier, std::vector<bool>(p.form.count(), false), least.misfit};
  if (least.misfit > good_balance) return result;
  p.form.read(least.l, result.multiplier);
  if (with_unique) result.unique = UniqueForces(p, least.l).find();
  return result;
}

}  // namespace wuerfel
