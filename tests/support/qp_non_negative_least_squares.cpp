#include "tests/support/qp_non_negative_least_squares.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wuerfel::test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The set of unknowns that may be positive, and the current point.
class Passive {
 public:
  Passive(const MatrixXd& A, const VectorXd& f)
      : A_(A), f_(f), u_(VectorXd::Zero(A.cols())), member_(A.cols()) {}

  [[nodiscard]] const VectorXd& u() const { return u_; }
  [[nodiscard]] bool has(Index j) const { return member_[j]; }
  void insert(Index j) { member_[j] = true; }

  /// Moves to the best point on the set, dropping what would turn negative on the way. False if
  /// `entered` was dropped at once, which only rounding can cause.
  bool relax(Index entered) {
    while (true) {
      const VectorXd target = least_squares();
      double step = 1.0;
      for (Index j = 0; j < u_.size(); ++j)
        if (has(j) && target[j] <= 0.0) step = std::min(step, u_[j] / (u_[j] - target[j]));
      if (step >= 1.0 && (target.array() > 0.0 || u_.array() == 0.0).all() && !blocked(target)) {
        u_ = target;
        return true;
      }
      u_ += step * (target - u_);
      if (!drop(target)) return false;
      if (!has(entered)) return false;
    }
  }

 private:
  [[nodiscard]] bool blocked(const VectorXd& target) const {
    for (Index j = 0; j < u_.size(); ++j)
      if (has(j) && target[j] <= 0.0) return true;
    return false;
  }

  /// Removes members that have reached zero; false if there was none.
  bool drop(const VectorXd& target) {
    bool dropped = false;
    const double small = 1e-15 * u_.cwiseAbs().maxCoeff();
    for (Index j = 0; j < u_.size(); ++j) {
      if (!has(j) || target[j] > 0.0 || u_[j] > small) continue;
      member_[j] = false;
      u_[j] = 0.0;
      dropped = true;
    }
    return dropped;
  }

  [[nodiscard]] VectorXd least_squares() const {
    std::vector<Index> columns;
    for (Index j = 0; j < u_.size(); ++j)
      if (has(j)) columns.push_back(j);
    const VectorXd part = MatrixXd(A_(Eigen::all, columns)).colPivHouseholderQr().solve(f_);
    VectorXd whole = VectorXd::Zero(u_.size());
    for (std::size_t k = 0; k < columns.size(); ++k)
      whole[columns[k]] = part[static_cast<Index>(k)];
    return whole;
  }

  const MatrixXd& A_;
  const VectorXd& f_;
  VectorXd u_;
  std::vector<bool> member_;
};

}  // namespace

VectorXd non_negative_least_squares(const MatrixXd& A, const VectorXd& f, double tolerance) {
  const VectorXd threshold = tolerance * f.norm() * A.colwise().norm().transpose();
  Passive passive(A, f);
  std::vector<bool> barred(A.cols(), false);
  for (Index round = 0; round < 10 * A.cols() + 10; ++round) {
    const VectorXd gradient = A.transpose() * (f - A * passive.u());
    Index best = -1;
    for (Index j = 0; j < A.cols(); ++j) {
      if (!passive.has(j) && !barred[j] && gradient[j] > threshold[j]
          && (best < 0 || gradient[j] > gradient[best]))
        best = j;
    }
    if (best < 0) break;
    passive.insert(best);
    if (passive.relax(best)) {
      std::fill(barred.begin(), barred.end(), false);
    } else {
      barred[best] = true;
    }
  }
  return passive.u();
}

}  // namespace wuerfel::test
