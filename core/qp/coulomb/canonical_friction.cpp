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
/// Of the largest force: wishes of other ones, each with its opposite. Far ones lead to the ends of what is possible, near ones often
/// back to the forces of least norm.
constexpr std::array wish_sizes{1.0, 30.0, 1000.0};

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

/// Forces that are by more than `least` N away from the canonical ones are not the only ones.
void mark_moved(const std::vector<Pair>& l,
                const std::vector<Pair>& canonical,
                double least,
                std::vector<bool>& unique) {
  for (std::size_t i = 0; i < unique.size(); ++i) {
    const double change =
        std::max(std::abs(l[i].n - canonical[i].n), std::abs(l[i].t - canonical[i].t));
    if (change > least) unique[i] = false;
  }
}

/// Whether any of the marked units may carry something.
bool any_carries(const ForceProblem& p, const std::vector<bool>& marked) {
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i] && p.cone[i] != Cone::nothing) return true;
  return false;
}

/// A force is the only one possible if wishes of other ones do not move it, and are granted.
std::vector<bool> find_unique(ForceProblem& p, const std::vector<Pair>& least) {
  const std::vector<int> first = first_alike(p.form);
  const std::vector<Pair> canonical = with_sums(least, first);
  double force = 0.0;
  for (const Pair& l : canonical)
    force = std::max({force, std::abs(l.n), std::abs(l.t)});
  if (force == 0.0) force = 1.0;  // what is braced presses as hard as it likes
  std::vector<bool> unique(canonical.size(), true);
  Dice dice(canonical.size());
  std::vector<Pair> wish(canonical.size());
  bool searched = !any_carries(p, unique);
  for (const double size : wish_sizes) {
    if (!any_carries(p, unique)) break;
    for (Pair& w : wish)
      w = {size * force * (2.0 * dice.next() - 1.0), size * force * (2.0 * dice.next() - 1.0)};
    for (int opposite = 0; opposite < 2; ++opposite) {
      const NearestForces other = nearest(p, wish);
      searched = searched || other.misfit <= good_balance;
      if (other.misfit <= good_balance)
        mark_moved(with_sums(other.l, first), canonical, same_force * force, unique);
      for (Pair& w : wish)
        w = {-w.n, -w.t};
    }
  }
  if (!searched) unique.assign(unique.size(), false);
  return unique;
}

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
  if (with_unique) result.unique = find_unique(p, least.l);
  return result;
}

}  // namespace wuerfel
