/// The exact solver for Coulomb's law in the plane.
///
/// Stages, each judged by CoulombJudge, the first within the tolerance is the answer:
///
///     certificate   the last forces still solve this program
///     newton        from the modes remembered, or what would meet sticking; with more compliance; by a short path
///     convex        the convex relaxation, where it happens to satisfy the exact law; then newton
///                   from its modes; not asked where something slipped in the modes remembered
///     interior      the interior point method on the exact law, several times; from there newton, or
///                   proximal steps along piecewise linear paths
///     path          the piecewise linear path from the point that is best so far
///     lemke         the path from all contacts open, which always arrives but for rounding; three
///                   covering vectors
///
/// Where directions of slip are known there may be no solution (Painleve): `infeasible`, also where
/// a force is beyond 1e6 weights; else the solution nearest to the modes remembered.
///
/// What misses the tolerance in all of them is the best point of all, `inaccurate` with its
/// residual. Deterministic: what is random is seeded by the number of contacts.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/qp/coulomb/coulomb_residual.h"
#include "core/qp/coulomb/friction_program.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

enum class CoulombStage { none, certificate, newton, convex, interior, path, lemke };
std::string_view to_string(CoulombStage stage);

struct [[nodiscard]] CoulombResult {
  QpStatus status = QpStatus::invalid;
  std::vector<double> x;                    ///< n
  std::vector<double> multiplier;           ///< m
  CoulombResidual residual;                 ///< of the exact law
  CoulombStage stage = CoulombStage::none;  ///< that found the answer
  int factorisations = 0;
  int crossings = 0;  ///< of paths
  /// The exact law was not reached; the point is the best one found.
  [[nodiscard]] bool inexact() const { return status == QpStatus::inaccurate; }
};

struct CoulombSettings {
  double tolerance = 1e-10;  ///< on CoulombResidual::worst()
};

class CoulombSolver {
 public:
  explicit CoulombSolver(const CoulombSettings& settings = {});
  ~CoulombSolver();
  CoulombSolver(const CoulombSolver&) = delete;
  CoulombSolver& operator=(const CoulombSolver&) = delete;

  /// Solves into `result`, whose vectors are reused. `keys` name the contacts from call to call, one
  /// each and no two alike; without keys the modes are remembered if there are as many contacts and
  /// rows as before.
  void solve(const FrictionProgram& friction,
             CoulombResult& result,
             std::span<const std::uint64_t> keys = {});
  void forget();

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

/// The first thing wrong with the program, or an empty text.
std::string_view defect(const FrictionProgram& friction);

}  // namespace wuerfel
