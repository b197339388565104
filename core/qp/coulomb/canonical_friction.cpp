#include "core/qp/coulomb/canonical_friction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/qp/block/quad_vector.h"
#include "core/qp/coulomb/contact_form.h"
#include "core/qp/coulomb/dice.h"

namespace wuerfel {
namespace {

constexpr double stiffness = 1e6;  ///< in units of 1 / |g|^2
constexpr int most_newton_steps = 60;
constexpr int most_rounds = 100;
constexpr double exact_balance = 1e-14;
constexpr double good_balance = 1e-8;
constexpr double same_force = 1e-7;  ///< of the largest
/// Of the largest force: wishes of other ones, each with its opposite. Far ones lead to the ends of what is possible, near ones often
/// back to the forces of least norm.
constexpr std::array wish_sizes{1.0, 30.0, 1000.0};
constexpr double same_row = 1e-9;

enum class Cone : signed char { nothing, free, half_line, edge, cone };
/// Where on its cone a projection falls.
enum class Face : signed char { out, in, edge_forward, edge_back };

/// The forces that are sought: in cones, and with G' l = s.
struct ForceProblem {
  ContactForm form;
  std::vector<Cone> cone;
  std::vector<double> slip;  ///< sign of u_t of units that slip
  std::vector<Quad> s;
  double rho = 0.0;
};

/// Of a round: the forces nearest to `wish`, whatever it is, that balance `shift`, s_k.
struct Goal {
  const std::vector<Pair>& wish;
  std::vector<Quad> shift;
};

struct Iterate {
  std::vector<Quad> z;
  std::vector<Pair> Gz;
  std::vector<Pair> l;  ///< P_K(wish + G z)
  std::vector<Face> face;
};

struct Direction {
  std::vector<Quad> d;
  std::vector<Pair> Gd;
};

/// The cones of units from un and ut at x.
void classify(const FrictionProgram& friction, const std::vector<double>& x, ForceProblem& p) {
  p.cone.assign(p.form.count(), Cone::free);
  p.slip.assign(p.form.count(), 0.0);
  for (int i = 0; i < p.form.count(); ++i) {
    const ContactUnit& unit = p.form.units()[i];
    if (unit.equality) continue;
    p.cone[i] = Cone::nothing;
    if (friction.program.slack(unit.normal, x) * unit.per_velocity.n > still_share) continue;
    p.cone[i] = Cone::half_line;
    if (unit.tangent < 0) continue;
    const double ut = friction.program.slack(unit.tangent, x);
    const bool slips = std::abs(ut) * unit.per_velocity.t > still_share;
    p.slip[i] = unit.slides != 0 ? unit.slides : slips ? std::copysign(1.0, ut) : 0.0;
    p.cone[i] = p.slip[i] != 0.0 ? Cone::edge : Cone::cone;
  }
}

ForceProblem problem_of(const FrictionProgram& friction,
                        const std::vector<double>& x,
                        const std::vector<double>& multiplier) {
  ForceProblem p;
  CoulombJudge judge;
  const CoulombScales& scales = judge.measure_scales(friction.program);
  // The forces must balance, whatever the masses are: without their ratios rows are more alike.
  QuadraticProgram program = friction.program;
  for (int j = program.unknowns() - 1; j >= 0; --j)
    program.mass[j] /= program.mass[j - j % program.block_size];
  std::fill(program.target.begin(), program.target.end(), 0.0);
  p.form.prepare({program, friction.contacts}, scales);
  classify(friction, x, p);
  std::vector<Pair> l;
  double square = 0.0;
  for (const ContactUnit& unit : p.form.units()) {
    l.push_back({multiplier[unit.normal], unit.tangent >= 0 ? multiplier[unit.tangent] : 0.0});
    square = std::max(square, unit.square.n);
  }
  p.rho = stiffness / square;
  p.s.resize(p.form.blocks());
  p.form.apply_transposed(l.data(), p.s.data());
  return p;
}

/// The projection of v onto the cone of a unit, and on which face it falls.
Face project(const ForceProblem& p, int i, Pair& v) {
  const double mu = p.form.units()[i].mu;
  switch (p.cone[i]) {
    case Cone::nothing:
      v = {};
      return Face::out;
    case Cone::free:
      v.t = 0.0;
      return Face::in;
    case Cone::half_line:
      v = {std::max(v.n, 0.0), 0.0};
      return v.n > 0.0 ? Face::in : Face::out;
    case Cone::edge:
    case Cone::cone:
      break;
  }
  if (p.cone[i] == Cone::cone && std::abs(v.t) <= mu * v.n) return Face::in;
  const double s = p.cone[i] == Cone::edge ? p.slip[i] : std::copysign(1.0, -v.t);
  const double along = (v.n - s * mu * v.t) / (1.0 + mu * mu);
  if (along <= 0.0) {
    v = {};
    return Face::out;
  }
  v = {along, -s * mu * along};
  return s > 0.0 ? Face::edge_forward : Face::edge_back;
}

/// The derivative of the projection, times rho.
ContactForm::Weight face_weight(const ForceProblem& p, int i, Face face) {
  if (face == Face::out) return {};
  if (face == Face::in) return {.nn = p.rho, .tt = p.cone[i] == Cone::cone ? p.rho : 0.0};
  const double mu = p.form.units()[i].mu;
  const double e = face == Face::edge_forward ? -mu : mu;
  const double share = p.rho / (1.0 + e * e);
  return {.nn = share, .nt = share * e, .tn = share * e, .tt = share * e * e};
}

/// The forces at z and their faces; whether these are the same as before.
bool find_forces(const ForceProblem& p, const Goal& goal, Iterate& at) {
  bool same = true;
  for (int i = 0; i < p.form.count(); ++i) {
    at.l[i] = {goal.wish[i].n + at.Gz[i].n, goal.wish[i].t + at.Gz[i].t};
    const Face face = project(p, i, at.l[i]);
    same = same && face == at.face[i];
    at.face[i] = face;
  }
  return same;
}

/// d = -(1/rho + G' D G)^-1 (z / rho + G' l - shift) with the factor at hand.
void find_direction(const ForceProblem& p, const Goal& goal, const Iterate& at, Direction& step) {
  p.form.apply_transposed(at.l.data(), step.d.data());
  for (std::size_t b = 0; b < step.d.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      step.d[b].v[c] = (goal.shift[b].v[c] - step.d[b].v[c]) * p.rho - at.z[b].v[c];
  }
  p.form.solve(step.d.data());
  p.form.apply(step.d.data(), step.Gd.data());
}

/// Derivative along the step, a part of it ahead.
double slope(const ForceProblem& p,
             const Goal& goal,
             const Iterate& at,
             const Direction& step,
             double part) {
  const auto& [d, Gd] = step;
  double sum = (dot(at.z, d) + part * dot(d, d)) / p.rho - dot(goal.shift, d);
  for (int i = 0; i < p.form.count(); ++i) {
    Pair v{goal.wish[i].n + at.Gz[i].n + part * Gd[i].n,
           goal.wish[i].t + at.Gz[i].t + part * Gd[i].t};
    (void)project(p, i, v);
    sum += v.n * Gd[i].n + v.t * Gd[i].t;
  }
  return sum;
}

/// The part of the step at which the slope vanishes; it is positive at its end.
double root_of_slope(const ForceProblem& p,
                     const Goal& goal,
                     const Iterate& at,
                     const Direction& step) {
  double low = 0.0;
  double high = 1.0;
  for (int half = 0; half < 40; ++half) {
    const double middle = 0.5 * (low + high);
    (slope(p, goal, at, step, middle) > 0.0 ? high : low) = middle;
  }
  return high;
}

void move(double part, const Direction& step, Iterate& at) {
  add(part, step.d, at.z);
  for (std::size_t i = 0; i < at.Gz.size(); ++i) {
    at.Gz[i].n += part * step.Gd[i].n;
    at.Gz[i].t += part * step.Gd[i].t;
  }
}

/// Newton's steps on the faces, with an exact line search; ends where a whole step keeps them.
bool minimise(ForceProblem& p, const Goal& goal, Iterate& at, Direction& step) {
  std::vector<ContactForm::Weight> weight(p.form.count());
  p.form.apply(at.z.data(), at.Gz.data());
  find_forces(p, goal, at);
  for (int k = 0; k < most_newton_steps; ++k) {
    for (int i = 0; i < p.form.count(); ++i)
      weight[i] = face_weight(p, i, at.face[i]);
    if (!p.form.factorise(weight)) return false;
    for (int refinement = 0; refinement < 2; ++refinement) {
      find_direction(p, goal, at, step);
      const bool too_far = slope(p, goal, at, step, 1.0) > 0.0 && refinement == 0;
      move(too_far ? root_of_slope(p, goal, at, step) : 1.0, step, at);
      if (!find_forces(p, goal, at)) break;
      if (refinement == 1) return true;
    }
  }
  return false;
}

struct NearestForces {
  std::vector<Pair> l;
  double misfit = unbounded;  ///< of G' l = s
};

double largest(const std::vector<Quad>& v) {
  double most = 0.0;
  for (const Quad& q : v)
    most = std::max(most, largest(q));
  return most;
}

NearestForces nearest(ForceProblem& p, const std::vector<Pair>& wish) {
  Goal goal{wish, p.s};
  Iterate at{std::vector<Quad>(p.s.size()), std::vector<Pair>(wish.size()),
             std::vector<Pair>(wish.size()), std::vector<Face>(wish.size())};
  Direction step{at.z, at.Gz};
  std::vector<Quad> missed(p.s.size());
  double misfit = unbounded;
  const double size = largest(p.s);
  for (int round = 0; round < most_rounds && misfit > exact_balance; ++round) {
    if (!minimise(p, goal, at, step)) break;
    p.form.apply_transposed(at.l.data(), missed.data());
    for (std::size_t b = 0; b < missed.size(); ++b) {
      for (int c = 0; c < 3; ++c)
        missed[b].v[c] = p.s[b].v[c] - missed[b].v[c];
    }
    add(1.0, missed, goal.shift);
    const double now = size > 0.0 ? largest(missed) / size : largest(missed);
    if (now >= misfit && misfit < good_balance) break;
    misfit = now;
  }
  return {std::move(at.l), misfit};
}

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
  std::vector<bool> unique(canonical.size(), true);
  Dice dice(canonical.size());
  std::vector<Pair> wish(canonical.size());
  bool searched = false;
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
