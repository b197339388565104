/// How many times a load can be added to weights before the contacts cannot balance them: all s with
///
///     G f + w + s q = 0,   f >= 0.                                                        (E)
///
/// By Gauss' principle. a(s), the minimiser of 1/2 |a - M^-1 (w + s q)|_M^2 under G' a >= 0, is zero
/// if and only if (E) has a solution. If it is not it proves that there is none [Farkas 1902]: no
/// contact closes, and the loads have power <w + s q, a> = |a|_M^2 > 0. Any forces of (E) at s' give
/// <w + s' q, a> <= 0, so that each a is a cut s' <= -<w, a> / <q, a>. The cuts are the steps of
/// Newton's method for the zero of the convex function |a(s)|_M, from above: finitely many, one for
/// each face of the cone. The last motion is the collapse mechanism of limit analysis, (E) its static
/// theorem [Livesley 1978].
///
/// Near the end a cut divides two tiny numbers. So it is taken from the load alone: with S, the rows
/// that carry force just above, d = the part of M^-1 q orthogonal to S has the same direction as a(s)
/// and is found by one linear system; -<w, d> / <q, d> is exact for the whole face.
///
/// Where G has independent columns (statically determinate: towers, overhangs, beams on two tips) f is
/// an affine function of s, and its signs alone decide: two linear systems.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/qp/methods/equality_solver.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

/// From low to high, both included; infinite where there is no limit.
struct LoadRange {
  double low = -unbounded;
  double high = unbounded;
  double error = 0.0;  ///< width of the bracket around each end

  [[nodiscard]] bool contains(double s) const { return low <= s && s <= high; }
  /// In units of which the load's is so many.
  [[nodiscard]] LoadRange times(double factor) const {
    return {low * factor, high * factor, error * factor};
  }
};

/// Where there is no s at all.
inline constexpr LoadRange no_load{unbounded, -unbounded, 0.0};
inline bool is_empty(const LoadRange& range) { return range.low > range.high; }
/// With an s that is known to be one. An end that misses it by no more than `rounding` moves there, be it past the other;
/// where one misses it by more the range is not known, and empty.
LoadRange around(double s, const LoadRange& range, double rounding);

/// A cut that is known before any program is solved: no s above it has forces.
struct KnownCut {
  double s = unbounded;
  double sharpness = 0.0;  ///< <q, a>^2 / (|a|_M |M^-1 q|_M)^2 of the motion a that it comes from
};

class LoadFactor {
 public:
  /// Generators as rows; bounds and targets are not looked at.
  explicit LoadFactor(const QuadraticProgram& program);

  /// Loads (N, N m) as vectors of n. q should be about as large as w.
  LoadRange range(const std::vector<double>& w,
                  const std::vector<double>& q,
                  const KnownCut& above = {},
                  const KnownCut& below = {});

  /// The low end alone; infinite where there is no s, -infinite where there is no limit.
  double low(const std::vector<double>& w, const std::vector<double>& q);

 private:
  struct Top {
    double s = unbounded;  ///< the largest one; -infinity: there is none
    double error = 0.0;
    bool exact = false;  ///< from a motion that is known to its last digits
  };
  struct Cut {
    double s = 0.0;
    bool none = false;  ///< the load cannot help: there is no s below
    bool exact = false;
    double error = unbounded;  ///< relative, of one that is not exact
  };
  Top top(const std::vector<double>& w, const std::vector<double>& q, const KnownCut& known);
  static Top bounded_by_more_than_rounding(Top top);
  void confirm(const std::vector<double>& w, const std::vector<double>& q, Top& found);
  Top make_sure(const std::vector<double>& w,
                const std::vector<double>& q,
                double error,
                bool last,
                Top found);
  std::optional<Top> end_in_rounding(const std::vector<double>& w,
                                     const std::vector<double>& q,
                                     Top found,
                                     const Cut& next);
  bool is_determinate();
  /// The only forces that leave of a load nothing but `x`.
  void solve_all(const std::vector<double>& load, std::vector<double>& x, std::vector<double>& f);
  bool determinate_range(const std::vector<double>& w,
                         const std::vector<double>& q,
                         LoadRange& range);
  Cut cut(const std::vector<double>& w, const std::vector<double>& q);
  bool exact_cut(const std::vector<double>& w, const std::vector<double>& q, double& s);
  [[nodiscard]] bool hinders(const std::vector<double>& d) const;
  [[nodiscard]] bool is_large() const;
  /// Solves for w + s q; true where there are forces.
  bool balances(const std::vector<double>& w, const std::vector<double>& q, double s);
  [[nodiscard]] bool is_drowned() const;
  [[nodiscard]] double largest(const std::vector<double>& a) const;

  QuadraticProgram program_;
  std::unique_ptr<QpSolver> solver_;
  QpResult result_;         ///< of the last `balances`
  double unrest_ = 0.0;     ///< its largest acceleration, relative to that of the load
  double noise_ = 0.0;      ///< relative, of the last cut, where that is not exact
  double sharpness_ = 0.0;  ///< of the last exact cut, as in KnownCut
  EqualitySolver equalities_;
  EqualitySolver all_rows_;
  std::optional<bool> determinate_;  ///< none: not known yet
  std::vector<double> row_norm_;
  std::vector<char> tight_;
  std::vector<double> d_, multiplier_;
};

}  // namespace wuerfel
