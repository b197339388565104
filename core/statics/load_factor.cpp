#include "core/statics/load_factor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/dynamics/gauss.h"

namespace wuerfel {
namespace {

/// Of the programs: a hundredth of what `check` asks, since cuts divide what is left.
constexpr double program_tolerance = 1e-12;
/// A motion below this share of the largest acceleration at hand is rounding.
constexpr double at_rest = 1e-11;
constexpr double nearly_at_rest = 1e-9;
/// A motion keeps clear of a row whose rate is not below this share of its own.
constexpr double clear = 1e-10;
/// A load with less than this share of the power it could have has none.
constexpr double powerless = 1e-9;
/// Of determinate forces, relative to the largest of their kind: rounding.
constexpr double no_share = 1e-12;
/// How far above the end the rows that carry force there are looked up.
constexpr std::array just_above{1e-6, 1e-5, 1e-4, 1e-3};
/// An end is known where what is left of the motion, over the sharpness of the motion above it, is less:
/// that is its error. Of motions that are not exact both have to do better.
constexpr double certain = 1e-12;
constexpr double certain_of_any = 1e-14;
constexpr double sharp = 1e-6;
/// In a large program a motion far above the end is exact enough.
constexpr double certain_of_large = 1e-10;
constexpr int many_rows = 600;
constexpr double far_above = 1e-4;
constexpr int most_cuts = 100;
/// Two exact cuts that differ by no more than this share are the same.
constexpr double agreeing = 1e-8;
/// Ends that cross by no more than this share are one point.
constexpr double one_point = 1e-12;
/// Of accelerations, relative to the largest, and how many times that a cut may be off.
constexpr double rounding = 1e-15;
constexpr double cut_noise = 100.0;
/// A load so many times as large as the weights drowns them: what it needs to be more is never enough.
constexpr double drowning = 1e9;
constexpr double digits_of_ends = 1e-6;
/// Forces so many times as large as the load, of cubes that wedge one another, leave it too few digits.
constexpr double drowned = 1e4;

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

std::vector<double> reversed(std::vector<double> q) {
  for (double& x : q)
    x = -x;
  return q;
}

/// One point, whose two ends rounding has crossed.
LoadRange uncrossed(LoadRange range) {
  if (is_empty(range) && range.low - range.high <= one_point * (1.0 + std::abs(range.low)))
    std::swap(range.low, range.high);
  return range;
}

}  // namespace

LoadRange around(double s, const LoadRange& range, double rounding) {
  const double missed = std::max({range.low - s, s - range.high, 0.0});
  if (missed > rounding) return no_load;
  return {std::min(range.low, s), std::max(range.high, s), std::max(range.error, missed)};
}

LoadFactor::LoadFactor(const QuadraticProgram& program)
    : program_(program),
      solver_(
          make_qp_solver(QpMethod::automatic, {.tolerance = program_tolerance, .by_block = true})),
      row_norm_(program.rows()),
      tight_(program.rows()) {
  std::ranges::fill(program_.bound, 0.0);
  for (int row = 0; row < program_.rows(); ++row) {
    program_.for_each_entry(row, [&](const double* J, int first, int size) {
      for (int c = 0; c < size; ++c)
        row_norm_[row] += J[c] * J[c] * program_.mass[first] / program_.mass[first + c];
    });
    row_norm_[row] = std::sqrt(row_norm_[row]);
  }
}

/// The largest acceleration of a block; turning counts times the radius of gyration.
double LoadFactor::largest(const std::vector<double>& a) const {
  double most = 0.0;
  for (int k = 0; k < program_.unknowns(); k += program_.block_size) {
    double square = 0.0;
    for (int c = k; c < k + program_.block_size; ++c)
      square += a[c] * a[c] * program_.mass[c] / program_.mass[k];
    most = std::max(most, square);
  }
  return std::sqrt(most);
}

/// Whether what balances the load is too small a part of the forces.
bool LoadFactor::is_drowned() const {
  double load = 0.0;
  for (int k = 0; k < program_.unknowns(); k += program_.block_size) {
    const double f = std::hypot(program_.mass[k] * program_.target[k],
                                program_.mass[k + 1] * program_.target[k + 1]);
    const double turn = std::sqrt(program_.mass[k] * program_.mass[k + 2]) * program_.target[k + 2];
    load = std::max({load, f, std::abs(turn)});
  }
  return std::ranges::any_of(result_.multiplier,
                             [&](double f) { return std::abs(f) > drowned * load; });
}

bool LoadFactor::balances(const std::vector<double>& w, const std::vector<double>& q, double s) {
  for (int k = 0; k < program_.unknowns(); ++k)
    program_.target[k] = (w[k] + s * q[k]) / program_.mass[k];
  const double scale = largest(program_.target);
  unrest_ = 0.0;
  if (scale == 0.0) {
    result_.x.assign(program_.unknowns(), 0.0);
    result_.multiplier.assign(program_.rows(), 0.0);
    return true;
  }
  solver_->solve(program_, result_);
  // Cubes that can wedge one another may do so as hard as they like, and what is remembered makes it harder and harder.
  if (is_drowned()) {
    solver_->forget();
    solver_->solve(program_, result_);
  }
  unrest_ = largest(result_.x) / scale;
  return unrest_ <= at_rest;
}

/// Whether a row of one sign would close.
bool LoadFactor::hinders(const std::vector<double>& d) const {
  const double least = -clear * largest(d);
  for (int row = 0; row < program_.rows(); ++row)
    if (tight_[row] == 0 && program_.row_value(row, d) < least * row_norm_[row]) return true;
  return false;
}

/// The cut of the load's own part that the carrying rows leave free, where that is a motion.
bool LoadFactor::exact_cut(const std::vector<double>& w, const std::vector<double>& q, double& s) {
  double most = 0.0;
  for (const double f : result_.multiplier)
    most = std::max(most, std::abs(f));
  const double least = pressing_share * most;
  for (int row = 0; row < program_.rows(); ++row)
    tight_[row] = program_.is_equality(row) || result_.multiplier[row] > least ? 1 : 0;
  for (int k = 0; k < program_.unknowns(); ++k)
    program_.target[k] = q[k] / program_.mass[k];
  equalities_.factorise(program_, &tight_);
  equalities_.solve(program_, d_, multiplier_);
  const double power = dot(q, d_);
  if (power <= powerless * dot(q, program_.target) || hinders(d_)) return false;
  s = -dot(w, d_) / power;
  sharpness_ = power / dot(q, program_.target);  // |d|_M^2 is <q, d>
  return true;
}

bool LoadFactor::is_large() const { return program_.rows() > many_rows; }

LoadFactor::Cut LoadFactor::cut(const std::vector<double>& w, const std::vector<double>& q) {
  const std::vector<double> a = result_.x;
  const double power = dot(q, a);
  double of_load = 0.0;    // |M^-1 q|_M^2
  double of_motion = 0.0;  // |a|_M^2
  for (int k = 0; k < program_.unknowns(); ++k) {
    of_load += q[k] * q[k] / program_.mass[k];
    of_motion += a[k] * a[k] * program_.mass[k];
  }
  if (power <= powerless * std::sqrt(of_load * of_motion)) return {0.0, true, false};
  double s = -dot(w, a) / power;
  double exact = 0.0;
  sharpness_ = 0.0;
  // What is left of a motion near the end is known to its rounding only.
  noise_ = cut_noise * std::max(rounding, result_.residual.worst()) / unrest_;
  // Far above the end a large program does not pay for it.
  if (is_large() && unrest_ > far_above) return {s, false, false, noise_};
  if (!exact_cut(w, q, exact)) return {s};
  if (exact - s > noise_ * (1.0 + std::abs(s))) return {s};
  return {exact, false, true};
}

/// The same end again from the face just above it, so far above that its motion is seen.
void LoadFactor::confirm(const std::vector<double>& w, const std::vector<double>& q, Top& found) {
  double exact = 0.0;
  for (const double step : just_above) {
    const double above = found.s + step * (1.0 + std::abs(found.s));
    found.error = above - found.s;
    if (balances(w, q, above)) continue;
    if (!exact_cut(w, q, exact)) return;
    found.error = std::abs(found.s - exact);
    if (!found.exact || exact < found.s - agreeing * (1.0 + std::abs(found.s))) found.s = exact;
    return;
  }
}

/// The error of what was found, from a last cut that was off by `error`; where that says too little, by another way.
LoadFactor::Top LoadFactor::make_sure(const std::vector<double>& w,
                                      const std::vector<double>& q,
                                      double error,
                                      bool last,
                                      Top found) {
  if (found.exact && unrest_ <= certain * sharpness_) {
    found.error = unrest_ / sharpness_;
  } else if (is_large() && error <= certain_of_large) {
    found.error = error * (1.0 + std::abs(found.s));
  } else if (last || unrest_ > certain_of_any || sharpness_ < sharp) {
    confirm(w, q, found);
  }
  return found;
}

/// An exact cut that leaves next to no motion is the end if the lower one that follows is what rounding has left of it.
std::optional<LoadFactor::Top> LoadFactor::end_in_rounding(const std::vector<double>& w,
                                                           const std::vector<double>& q,
                                                           Top found,
                                                           const Cut& next) {
  if (!found.exact || next.exact || next.none) return std::nullopt;
  const double noise = noise_ * (1.0 + std::abs(found.s));
  if (found.s - next.s <= noise) return make_sure(w, q, next.error, true, found);
  if (unrest_ > nearly_at_rest) return std::nullopt;
  // A cut may be worse than its noise tells: the end is seen from above.
  confirm(w, q, found);
  if (found.error > agreeing * (1.0 + std::abs(found.s))) return std::nullopt;
  return found;
}

LoadFactor::Top LoadFactor::top(const std::vector<double>& w,
                                const std::vector<double>& q,
                                const KnownCut& known) {
  constexpr double none = -unbounded;
  Cut next{known.s, false, true};
  sharpness_ = known.sharpness;
  if (known.s == unbounded) {
    const std::vector<double> nothing(q.size(), 0.0);
    // What is next to balanced has an end that drowns the weights.
    if (balances(q, nothing, 0.0) || unrest_ <= nearly_at_rest) return {};
    next = cut(w, q);
  }
  Top found{next.s};
  for (int k = 0; k < most_cuts; ++k) {
    // Where the only s is the one reached, rounding is all that is left of the motion.
    if (next.none && unrest_ <= nearly_at_rest)
      return {found.s, unrest_ * (1.0 + std::abs(found.s)), true};
    if (next.none || next.s < -drowning) return {none};
    const double step = found.s - next.s;
    found.s = next.s;
    found.exact = next.exact;
    // No cut goes below this one, or there are forces.
    const bool last = k > 0 && step <= 1e-14 * std::abs(found.s);
    if (last || balances(w, q, found.s)) return make_sure(w, q, next.error, last, found);
    next = cut(w, q);
    if (const std::optional<Top> end = end_in_rounding(w, q, found, next)) return *end;
  }
  return {none};
}

bool LoadFactor::is_determinate() {
  if (determinate_) return *determinate_;
  determinate_ = program_.rows() <= program_.unknowns();
  if (!*determinate_) return false;
  all_rows_.factorise(program_);
  determinate_ = all_rows_.dependent_rows() == 0;
  return *determinate_;
}

void LoadFactor::solve_all(const std::vector<double>& load,
                           std::vector<double>& x,
                           std::vector<double>& f) {
  for (int k = 0; k < program_.unknowns(); ++k)
    program_.target[k] = load[k] / program_.mass[k];
  all_rows_.solve(program_, x, f);
}

bool LoadFactor::determinate_range(const std::vector<double>& w,
                                   const std::vector<double>& q,
                                   LoadRange& range) {
  if (!is_determinate()) return false;
  std::vector<double> x;
  std::vector<double> of_load;
  std::vector<double> of_weights;
  solve_all(q, x, of_load);
  if (largest(x) > at_rest * largest(program_.target)) return false;
  solve_all(w, x, of_weights);
  range = no_load;
  if (largest(x) > at_rest * largest(program_.target)) return true;
  const auto none = [](const std::vector<double>& f) {
    double most = 0.0;
    for (const double one : f)
      most = std::max(most, std::abs(one));
    return no_share * most;
  };
  const double no_load_force = none(of_load);
  const double no_weight_force = none(of_weights);
  LoadRange found;
  for (int row = 0; row < program_.rows(); ++row) {
    if (program_.is_equality(row)) continue;
    const double f = std::abs(of_weights[row]) > no_weight_force ? of_weights[row] : 0.0;
    const double s = -f / of_load[row];
    if (std::abs(of_load[row]) > no_load_force && std::abs(s) < drowning) {
      double& end = of_load[row] > 0.0 ? found.low : found.high;
      end = of_load[row] > 0.0 ? std::max(end, s) : std::min(end, s);
    } else if (f < 0.0) {
      return true;
    }
  }
  range = uncrossed(found);
  return true;
}

/// An end that drowns the weights and is not known to six digits is none.
LoadFactor::Top LoadFactor::bounded_by_more_than_rounding(Top top) {
  if (top.s > drowning && top.error > digits_of_ends * top.s) return {};
  return top;
}

LoadRange LoadFactor::range(const std::vector<double>& w,
                            const std::vector<double>& q,
                            const KnownCut& above_at,
                            const KnownCut& below_at) {
  if (LoadRange found; determinate_range(w, q, found)) return found;
  const Top above = bounded_by_more_than_rounding(top(w, q, above_at));
  if (above.s == -unbounded) return no_load;
  const Top below = bounded_by_more_than_rounding(top(w, reversed(q), below_at));
  if (below.s == -unbounded) return no_load;
  if (above.s == unbounded && below.s == unbounded && !balances(w, q, 0.0)) return no_load;
  return uncrossed({-below.s, above.s, std::max(above.error, below.error)});
}

double LoadFactor::low(const std::vector<double>& w, const std::vector<double>& q) {
  return -top(w, reversed(q), {}).s;
}

}  // namespace wuerfel
