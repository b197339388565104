#include "core/qp/coulomb/nearest_forces.h"

#include <algorithm>
#include <cmath>

#include "core/qp/block/quad_vector.h"

namespace wuerfel {
namespace {

constexpr double stiffness = 1e6;  ///< in units of 1 / |g|^2
constexpr int most_newton_steps = 60;
constexpr int most_rounds = 100;
constexpr double exact_balance = 1e-14;
constexpr double held_share = 0.5;  ///< of what the round before missed
constexpr double same_miss = 0.99;  ///< cosine
constexpr double faster = 3.0;
/// Coefficients of friction of cones whose edges hold up what is still on its way.
constexpr double thin_cone = 1e-2;

/// Where on its cone a projection falls.
enum class Face : signed char { out, in, edge_forward, edge_back };

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
    case Cone::wide:
      if (v.n <= 0.0) v = {};
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
  const bool rubs = p.cone[i] == Cone::cone || p.cone[i] == Cone::wide;
  if (face == Face::in) return {.nn = p.rho, .tt = rubs ? p.rho : 0.0};
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

double largest(const std::vector<Quad>& v) {
  double most = 0.0;
  for (const Quad& q : v)
    most = std::max(most, largest(q));
  return most;
}

/// s - G' l
void find_missed(const ForceProblem& p, const Iterate& at, std::vector<Quad>& missed) {
  p.form.apply_transposed(at.l.data(), missed.data());
  for (std::size_t b = 0; b < missed.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      missed[b].v[c] = p.s[b].v[c] - missed[b].v[c];
  }
}

/// Times what a round misses that the next one takes up: ever more of what is missed again.
class Pace {
 public:
  /// Takes note of a round that missed by `misfit`; `along` is the cosine to what the one before missed.
  void follow(double misfit, double along) {
    const bool held_up = misfit > held_share * former_ && along > same_miss;
    settled_ = !held_up && times_ == 1.0 && misfit >= former_;
    if (!held_up && times_ > 1.0) most_ = along < 0.0 ? times_ / faster : unbounded;
    times_ = held_up ? std::min(faster * times_, most_) : 1.0;
    former_ = misfit;
  }
  [[nodiscard]] double times() const { return times_; }
  [[nodiscard]] bool settled() const { return settled_; }  ///< rounds gain nothing any more

 private:
  double former_ = unbounded;
  double times_ = 1.0;
  double most_ = unbounded;  ///< less where rounds have gone from one side to the other
  bool settled_ = false;
};

/// Rounds until forces balance: the best of them. What a face holds up, so that rounds miss the same again, they take up ever
/// faster.
NearestForces balance(ForceProblem& p, Goal& goal, Iterate& at, Direction& step) {
  NearestForces best;
  Pace pace;
  std::vector<Quad> missed(p.s.size());
  std::vector<Quad> former(p.s.size());
  const double size = largest(p.s);
  for (int round = 0; round < most_rounds && best.misfit > exact_balance; ++round) {
    if (!minimise(p, goal, at, step)) break;
    find_missed(p, at, missed);
    const double now = size > 0.0 ? largest(missed) / size : largest(missed);
    if (now < best.misfit) best = {at.l, now};
    // Not a number at first.
    pace.follow(now, dot(missed, former) / std::sqrt(dot(missed, missed) * dot(former, former)));
    if (pace.settled() && best.misfit < good_balance) break;
    add(pace.times(), missed, goal.shift);
    former = missed;
  }
  return best;
}

}  // namespace

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
  if (std::ranges::all_of(x, [](double v) { return v == 0.0; })) {
    std::vector<double> held(x.size());
    for (int j = 0; j < program.unknowns(); ++j)
      held[j] = -friction.program.target[j] * friction.program.mass[j] / program.mass[j];
    p.form.write(program, held, p.s);
  } else {
    p.s.resize(p.form.blocks());
    p.form.apply_transposed(l.data(), p.s.data());
  }
  return p;
}

NearestForces nearest(ForceProblem& p, const std::vector<Pair>& wish) {
  Goal goal{wish, p.s};
  Iterate at{std::vector<Quad>(p.s.size()), std::vector<Pair>(wish.size()),
             std::vector<Pair>(wish.size()), std::vector<Face>(wish.size())};
  Direction step{at.z, at.Gz};
  const std::vector<Cone> cones = p.cone;
  for (int i = 0; i < p.form.count(); ++i)
    if (cones[i] == Cone::cone && p.form.units()[i].mu < thin_cone) p.cone[i] = Cone::wide;
  if (p.cone != cones) (void)balance(p, goal, at, step);
  p.cone = cones;
  return balance(p, goal, at, step);
}

}  // namespace wuerfel
