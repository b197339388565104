/// Newton and interior point on one scaled problem with one factorisation, and what both leave to be
/// put right: points settled on the rows that carry force, the better of several answers kept.
#pragma once

#include <string_view>

#include "core/qp/methods/interior_point_method.h"
#include "core/qp/methods/newton_method.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

class BlockMethods {
 public:
  explicit BlockMethods(const QpSettings& settings,
                        const BlockKernels& kernels = best_block_kernels());

  /// Takes a program over. False if `result` says all there is to say: it is malformed, or a row
  /// without coefficients cannot hold.
  bool begin(const QuadraticProgram& program, QpResult& result);
  /// Newton steps from the sides known. True if the answer passes or proves that there is none.
  bool run_newton(const QuadraticProgram& program, const NewtonEffort& effort, QpResult& result);
  /// The interior point method, warm as long as that is faster than cold.
  void run_interior_point(const QuadraticProgram& program, QpResult& result);
  /// Sets the status of an answer.
  void end(QpResult& result) const;

  /// Lets newton start from where the interior point method has ended.
  void remember_interior_point() { newton_.remember(problem_, interior_point_.multiplier()); }
  void forget();

  /// The residual that newton aims at: far enough below the tolerance for x to be as exact.
  [[nodiscard]] double goal() const;
  [[nodiscard]] int blocks() const { return problem_.blocks(); }
  [[nodiscard]] const QpSettings& settings() const { return settings_; }
  [[nodiscard]] std::string_view trouble() const { return trouble_; }

 private:
  /// A point with its multipliers and what it is worth.
  struct Answer {
    std::vector<double> x;
    std::vector<double> multiplier;
    QpResidual residual;
  };
  /// A point on its way onto the rows that carry force.
  struct Settling {
    std::vector<Quad> y;
    std::vector<double> rest;     ///< h - G y
    std::vector<double> weight;   ///< of rows that are tight, 0 of the others
    std::vector<Quad> unbalance;  ///< G' lambda - y
    // Of one round.
    std::vector<Quad> d;
    std::vector<double> pull, Gd;
  };
  [[nodiscard]] bool has_impossible_row() const;
  bool try_interior_point(const QuadraticProgram& program,
                          bool warm,
                          double proximal,
                          QpResult& result);
  bool take(const QuadraticProgram& program,
            const MethodOutcome& outcome,
            double enough,
            const std::vector<Quad>& y,
            const std::vector<double>& multiplier,
            QpResult& result);
  void settle(const QuadraticProgram& program, Answer& answer);
  void start_settling(const std::vector<double>& multiplier, Settling& point) const;
  void weight_tight_rows(const std::vector<double>& multiplier, Settling& point) const;
  void move_onto_tight_rows(Settling& point, std::vector<double>& multiplier);

  QpSettings settings_;
  LeastDistance problem_;
  NewtonMethod newton_;
  InteriorPointMethod interior_point_;
  ResidualMeter meter_;
  std::string_view trouble_;
  bool solvable_ = false;  ///< a solution of the program is known to exist
  // Of the interior point runs last made.
  int warm_factorisations_ = 0;
  int cold_factorisations_ = 0;
  Answer answer_, settled_;
  Settling settling_;
};

}  // namespace wuerfel
