/// Least squares with unknowns that must not be negative, for small dense problems.
#pragma once

#include <Eigen/Dense>

namespace wuerfel::test {

/// argmin |A u - f| subject to u >= 0 by the finite method of Lawson and Hanson, Solving Least
/// Squares Problems (1974), chapter 23. `tolerance` is relative to |column| |f|: a column whose
/// gradient is smaller does not enter.
Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A,
                                           const Eigen::VectorXd& f,
                                           double tolerance = 1e-13);

}  // namespace wuerfel::test
