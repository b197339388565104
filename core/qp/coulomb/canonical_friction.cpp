#include "core/qp/coulomb/canonical_friction.h"

#include <algorithm>
#include <cmath>

#include "core/qp/coulomb/contact_modes.h"
#include "core/qp/coulomb/dice.h"

namespace wuerfel {
namespace {

constexpr double still = 1e-9;  ///< velocities below this share of the largest are zero
constexpr int most_newton_steps = 60;
constexpr int most_rounds = 100;
constexpr double exact_balance = 1e-14;
constexpr double good_balance = 1e-8;
constexpr double same_force = 1e-7;  ///< of the largest
constexpr int wishes = 3;            ///< and their opposites, of the search for other forces

double largest(const std::vector<Quad>& v) {
  double most = 0.0;
  for (const Quad& q : v)
    most = std::max({most, std::abs(q.v[0]), std::abs(q.v[1]), std::abs(q.v[2])});
  return most;
}

double dot(const std::vector<Quad>& a, const std::vector<Quad>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i].v[0] * b[i].v[0] + a[i].v[1] * b[i].v[1] + a[i].v[2] * b[i].v[2];
  return sum;
}

void add(double f, const std::vector<Quad>& d, std::vector<Quad>& y) {
  for (std::size_t b = 0; b < y.size(); ++b) {
    for (int c = 0; c < 3; ++c)
      y[b].v[c] += f * d[b].v[c];
  }
}

}  // namespace

/// What the motion allows each contact: seen from un and ut at x.
void CanonicalFriction::classify(const FrictionProgram& friction, const std::vector<double>& x) {
  CoulombJudge judge;
  const CoulombScales& scales = judge.measure_scales(friction.program);
  // The forces must balance, whatever the masses are: without their ratios rows are more alike.
  program_ = friction.program;
  for (int j = program_.unknowns() - 1; j >= 0; --j)
    program_.mass[j] /= program_.mass[j - j % program_.block_size];
  std::fill(program_.target.begin(), program_.target.end(), 0.0);
  form_.prepare({program_, friction.contacts}, scales);
  cone_.assign(form_.count(), Cone::free);
  slip_.assign(form_.count(), 0.0);
  const auto slack = [&](int row) {
    const QuadraticProgram& p = friction.program;
    double sum = -p.bound[row];
    for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e) {
      for (int c = 0; c < p.block_size; ++c)
        sum += p.coefficients[e * p.block_size + c] * x[p.entry_block[e] * p.block_size + c];
    }
    return sum;
  };
  for (int i = 0; i < form_.count(); ++i) {
    const ContactUnit& unit = form_.units()[i];
    if (unit.equality) continue;
    cone_[i] = Cone::nothing;
    if (slack(unit.normal) * unit.per_velocity.n > still) continue;
    cone_[i] = Cone::half_line;
    if (unit.tangent < 0) continue;
    const double ut = slack(unit.tangent);
    const bool slips = std::abs(ut) * unit.per_velocity.t > still;
    slip_[i] = unit.slides != 0 ? unit.slides : slips ? std::copysign(1.0, ut) : 0.0;
    cone_[i] = slip_[i] != 0.0 ? Cone::edge : Cone::cone;
  }
}

CanonicalFriction::Side CanonicalFriction::project(int i, Pair& v) const {
  const double mu = form_.units()[i].mu;
  switch (cone_[i]) {
    case Cone::nothing:
      v = {};
      return Side::out;
    case Cone::free:
      v.t = 0.0;
      return Side::in;
    case Cone::half_line:
      v = {std::max(v.n, 0.0), 0.0};
      return v.n > 0.0 ? Side::in : Side::out;
    case Cone::edge:
    case Cone::cone:
      break;
  }
  if (cone_[i] == Cone::cone && std::abs(v.t) <= mu * v.n) return Side::in;
  const double s = cone_[i] == Cone::edge ? slip_[i] : std::copysign(1.0, -v.t);
  const double along = (v.n - s * mu * v.t) / (1.0 + mu * mu);
  if (along <= 0.0) {
    v = {};
    return Side::out;
  }
  v = {along, -s * mu * along};
  return s > 0.0 ? Side::edge_forward : Side::edge_back;
}

/// The derivative of the projection, times rho.
ContactForm::Weight CanonicalFriction::face_weight(int i, Side side) const {
  const ContactUnit& unit = form_.units()[i];
  if (side == Side::out) return {};
  if (side == Side::in) {
    return {.nn = rho_, .tt = cone_[i] == Cone::cone ? rho_ : 0.0};
  }
  const double e = side == Side::edge_forward ? -unit.mu : unit.mu;
  const double share = rho_ / (1.0 + e * e);
  return {.nn = share, .nt = share * e, .tn = share * e, .tt = share * e * e};
}

/// l = P(wish + G z) and its sides; whether they are the same as before.
bool CanonicalFriction::find_sides(const std::vector<Pair>& wish) {
  bool same = true;
  for (int i = 0; i < form_.count(); ++i) {
    l_[i] = {wish[i].n + Gz_[i].n, wish[i].t + Gz_[i].t};
    const Side side = project(i, l_[i]);
    same = same && side == side_[i];
    side_[i] = side;
  }
  return same;
}

/// Derivative along d at z + step d.
double CanonicalFriction::slope(const std::vector<Pair>& wish, double step) {
  double sum = (dot(z_, d_) + step * dot(d_, d_)) / rho_ - dot(shift_, d_);
  for (int i = 0; i < form_.count(); ++i) {
    Pair v{wish[i].n + Gz_[i].n + step * Gd_[i].n, wish[i].t + Gz_[i].t + step * Gd_[i].t};
    (void)project(i, v);
    sum += v.n * Gd_[i].n + v.t * Gd_[i].t;
  }
  return sum;
}

/// d = -(1/rho + G' D G)^-1 (z / rho + G' l - shift) with the factor at hand.
void CanonicalFriction::find_direction() {
  form_.apply_transposed(l_.data(), balance_.data());
  d_ = shift_;
  add(-1.0, balance_, d_);
  for (Quad& q : d_) {
    for (int c = 0; c < 3; ++c)
      q.v[c] *= rho_;
  }
  add(-1.0, z_, d_);
  form_.solve(d_.data());
  form_.apply(d_.data(), Gd_.data());
}

/// Where within the step along d the slope vanishes; it is positive at its end.
double CanonicalFriction::root_of_slope(const std::vector<Pair>& wish) {
  double low = 0.0;
  double high = 1.0;
  for (int half = 0; half < 40; ++half) {
    const double middle = 0.5 * (low + high);
    (slope(wish, middle) > 0.0 ? high : low) = middle;
  }
  return high;
}

void CanonicalFriction::move(double step) {
  add(step, d_, z_);
  for (int i = 0; i < form_.count(); ++i) {
    Gz_[i].n += step * Gd_[i].n;
    Gz_[i].t += step * Gd_[i].t;
  }
}

/// Newton's steps on the sides, with an exact line search; ends where a whole step keeps them.
bool CanonicalFriction::minimise(const std::vector<Pair>& wish) {
  form_.apply(z_.data(), Gz_.data());
  find_sides(wish);
  for (int k = 0; k < most_newton_steps; ++k) {
    for (int i = 0; i < form_.count(); ++i)
      weight_[i] = face_weight(i, side_[i]);
    if (!form_.factorise(weight_)) return false;
    for (int refinement = 0; refinement < 2; ++refinement) {
      find_direction();
      const bool too_far = slope(wish, 1.0) > 0.0 && refinement == 0;
      move(too_far ? root_of_slope(wish) : 1.0);
      if (!find_sides(wish)) break;
      if (refinement == 1) return true;
    }
  }
  return false;
}

double CanonicalFriction::nearest(const std::vector<Pair>& wish) {
  shift_ = s_;
  for (Quad& q : z_)
    q = Quad{};
  const double size = largest(s_);
  double misfit = unbounded;
  for (int round = 0; round < most_rounds && misfit > exact_balance; ++round) {
    if (!minimise(wish)) break;
    form_.apply_transposed(l_.data(), balance_.data());
    d_ = s_;
    add(-1.0, balance_, d_);
    add(1.0, d_, shift_);
    const double now = size > 0.0 ? largest(d_) / size : largest(d_);
    if (now >= misfit && misfit < good_balance) break;
    misfit = now;
  }
  return misfit;
}

void CanonicalFriction::find(const FrictionProgram& friction,
                             const std::vector<double>& x,
                             const std::vector<double>& multiplier,
                             bool with_unique,
                             CanonicalForces& result) {
  classify(friction, x);
  for (auto* v : {&s_, &shift_, &z_, &d_, &balance_})
    v->assign(form_.blocks(), Quad{});
  for (auto* v : {&Gz_, &Gd_, &l_})
    v->assign(form_.count(), Pair{});
  side_.assign(form_.count(), Side::in);
  weight_.resize(form_.count());
  double square = 0.0;
  for (int i = 0; i < form_.count(); ++i) {
    const ContactUnit& unit = form_.units()[i];
    l_[i] = {multiplier[unit.normal], unit.tangent >= 0 ? multiplier[unit.tangent] : 0.0};
    square = std::max(square, unit.square.n);
  }
  rho_ = 1e6 / square;
  form_.apply_transposed(l_.data(), s_.data());
  result.misfit = nearest(std::vector<Pair>(l_.size(), Pair{}));
  result.multiplier = multiplier;
  result.unique.assign(form_.count(), false);
  if (result.misfit > good_balance) return;
  form_.read(l_, result.multiplier);
  if (with_unique) mark_unique(result, std::vector<Pair>(l_));
}

/// Forces that are by more than `least` N away from the canonical ones are not the only ones.
void CanonicalFriction::mark_moved(const std::vector<Pair>& canonical,
                                   double least,
                                   std::vector<bool>& unique) const {
  for (std::size_t i = 0; i < unique.size(); ++i) {
    const double change =
        std::max(std::abs(l_[i].n - canonical[i].n), std::abs(l_[i].t - canonical[i].t));
    if (change > least) unique[i] = false;
  }
}

/// A force is the only one possible if wishes of other ones do not move it.
void CanonicalFriction::mark_unique(CanonicalForces& result, const std::vector<Pair>& canonical) {
  double force = 0.0;
  for (const Pair& l : canonical)
    force = std::max({force, std::abs(l.n), std::abs(l.t)});
  result.unique.assign(result.unique.size(), true);
  Dice dice(canonical.size());
  std::vector<Pair> wish(canonical.size());
  for (int k = 0; k < wishes; ++k) {
    for (Pair& w : wish)
      w = {force * (2.0 * dice.next() - 1.0), force * (2.0 * dice.next() - 1.0)};
    for (int opposite = 0; opposite < 2; ++opposite) {
      if (nearest(wish) <= good_balance) mark_moved(canonical, same_force * force, result.unique);
      for (Pair& w : wish)
        w = {-w.n, -w.t};
    }
  }
}

}  // namespace wuerfel
