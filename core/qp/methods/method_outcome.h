/// What the two methods report, and how both measure their progress.
#pragma once

#include <vector>

#include "core/qp/block/least_distance.h"
#include "core/qp/residual_meter.h"

namespace wuerfel {

enum class MethodEnd { reached, stalled, infeasible };

/// How exact a method is to be, in the measure of QpResidual.
struct Aim {
  double residual;   ///< where it ends
  double tolerance;  ///< what passes for a solution
  bool solvable;     ///< a solution is known to exist
};

struct MethodOutcome {
  MethodEnd end = MethodEnd::stalled;
  double worst = 0.0;  ///< the residual found while solving
  int factorisations = 0;
};

/// The largest distance from y = 0 of a row that pushes from there.
double size_of(const LeastDistance& problem);

/// The worst row of a point y = G' lambda with rest = h - G y, as QpResidual measures it;
/// stationarity is exact there.
double worst_row(const LeastDistance& problem,
                 const ResidualScales& scales,
                 const std::vector<double>& rest,
                 const std::vector<double>& lambda);

/// Whether `direction` proves that no point satisfies the rows (Farkas): v >= 0 on inequalities
/// with |G' v| R + sum |v_i| d_i < h' v shows that every point that misses rows by at most d_i has
/// |y| > R. R = 1e7 times the size of the problem counts as none, d_i is what passes `tolerance` in
/// the measure of QpResidual. `scratch` is memory.
bool proves_infeasible(const LeastDistance& problem,
                       const ResidualScales& scales,
                       double tolerance,
                       const std::vector<double>& direction,
                       std::vector<double>& v,
                       std::vector<Quad>& scratch);

}  // namespace wuerfel
