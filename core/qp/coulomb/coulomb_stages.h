/// The stages of CoulombSolver on one program: each tries to find an answer, has it judged and keeps
/// the best.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/qp/coulomb/cone_interior_point.h"
#include "core/qp/coulomb/convex_relaxation.h"
#include "core/qp/coulomb/coulomb_solver.h"
#include "core/qp/coulomb/mode_newton.h"
#include "core/qp/coulomb/mode_path.h"
#include "core/qp/coulomb/proximal_path.h"

namespace wuerfel {

/// Where a path of `follow` begins.
enum class PathStart { here, open };
/// Contacts of programs for which the path from open is not too long.
inline constexpr std::size_t most_from_open = 600;
inline constexpr double soft_delta = 1e-2;  ///< compliance from which wrong modes do no harm

class CoulombStages {
 public:
  explicit CoulombStages(const CoulombSettings& settings);
  void prepare(const FrictionProgram& friction);
  void forget();

  /// Each true if the result is within the tolerance.
  bool certificate(const FrictionProgram& friction, CoulombResult& result);
  bool newton(const FrictionProgram& friction, int most_factorisations, CoulombResult& result);
  /// Newton's method with compliance that shrinks from `delta` on.
  bool harden(const FrictionProgram& friction,
              double delta,
              CoulombStage stage,
              CoulombResult& result);
  bool follow_shortly(const FrictionProgram& friction, CoulombResult& result);
  bool relax(const FrictionProgram& friction, CoulombResult& result);
  bool interior(const FrictionProgram& friction,
                double spread,
                std::uint64_t seed,
                Folds folds,
                CoulombResult& result);
  bool follow(const FrictionProgram& friction,
              PathStart start,
              std::uint64_t seed,
              Pivoting pivoting,
              CoulombResult& result);

  /// The point and the modes of these multipliers.
  void take(const std::vector<double>& multiplier);
  /// A force beyond 1e6 weights.
  [[nodiscard]] bool jams(const FrictionProgram& friction, const CoulombResult& result) const;
  /// What a contact of which nothing is known does.
  [[nodiscard]] static ContactMode first_mode(const ContactUnit& unit);
  [[nodiscard]] double weight() const { return scales_.weight; }
  [[nodiscard]] const ContactForm& form() const { return form_; }
  /// Of the point judged last, within their cones.
  [[nodiscard]] const std::vector<Pair>& forces() const { return cone_; }

  std::vector<ContactMode> modes;  ///< from which stages start, and where they end
  ContactPoint point;              ///< likewise
  bool solvable = true;  ///< whether a solution is known to exist: less is spent where not

 private:
  [[nodiscard]] bool rows_hold() const;
  [[nodiscard]] ModeNewtonEffort newton_effort(double delta, int most_factorisations) const;
  bool settle(const FrictionProgram& friction, CoulombStage stage, CoulombResult& result);
  bool approach(const FrictionProgram& friction,
                double delta,
                CoulombStage stage,
                CoulombResult& result);
  bool accept(const FrictionProgram& friction, CoulombStage stage, CoulombResult& result);
  bool judge_point(const FrictionProgram& friction, CoulombStage stage, CoulombResult& result);
  void find_modes();

  CoulombSettings settings_;
  CoulombJudge judge_;
  CoulombScales scales_;
  ContactForm form_;
  ConvexRelaxation convex_;
  ModeNewton mode_newton_;
  ConeInteriorPoint cone_interior_;
  ModePath mode_path_;
  ProximalPath proximal_path_;
  std::vector<Pair> cone_;
  std::vector<double> x_, multiplier_;
};

}  // namespace wuerfel
