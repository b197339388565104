/// Which method when: guess, newton, interior point, and what is remembered to choose among them.
#pragma once

#include <cstdint>

#include "core/qp/methods/active_set_method.h"
#include "core/qp/methods/block_methods.h"

namespace wuerfel {

/// `auto`. Programs whose rows have names are answered by a guess where that passes: rows that carried
/// force in the last program carry it again, mostly. Then newton, as long as it gets there; then the
/// interior point method.
class AutomaticSolver final : public QpSolver {
 public:
  explicit AutomaticSolver(const QpSettings& settings,
                           const BlockKernels& kernels = best_block_kernels());
  void solve(const QuadraticProgram& program, QpResult& result) override;
  [[nodiscard]] std::string_view name() const override { return to_string(QpMethod::automatic); }
  [[nodiscard]] std::string_view trouble() const override { return methods_.trouble(); }
  void forget() override;

 private:
  /// What newton's turns have shown.
  struct NewtonRecord {
    bool won = false;                ///< the last time
    bool knows_sides = false;        ///< it starts from those of a solution
    bool tried = false;              ///< from a guess
    bool tried_known_sides = false;  ///< from those of interior_point
    int since = 0;                   ///< solves since it was last tried
  };
  /// What guesses start from and how they have fared.
  struct GuessRecord {
    std::vector<std::int64_t> loaded;  ///< names of the rows with a force, sorted
    int failed = 0;                    ///< in a row
    int since = 0;                     ///< solves since the last one
  };

  void search(const QuadraticProgram& program, QpResult& result);
  bool newton_is_due();
  [[nodiscard]] NewtonEffort newton_effort() const;
  bool guess(const QuadraticProgram& program, QpResult& result);
  void improve(const QuadraticProgram& program, QpResult& result);
  void finish_off(const QuadraticProgram& program, double tolerance, QpResult& result);
  void remember_loads(const QuadraticProgram& program, const QpResult& result);
  void mark_loaded(const QuadraticProgram& program);

  BlockMethods methods_;
  ActiveSetMethod active_set_;
  NewtonRecord newton_;
  GuessRecord guesses_;
  std::vector<char> tight_;
};

}  // namespace wuerfel
