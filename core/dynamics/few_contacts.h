/// Few closed contacts: their equations, pulled back to the cubes, solved by one small dense
/// factorisation. What ProgramBuilder and EqualitySolver do for any number, without their
/// bookkeeping, which would take most of the time here.
#pragma once

#include <array>
#include <vector>

#include "core/constraints/islands.h"
#include "core/dynamics/contact_rows.h"

namespace wuerfel {

class FewContacts {
 public:
  static constexpr int most = 8;

  /// Rows for the contacts of an island, at most `most`, as they are now.
  void build(const System& system, const State& state, const Island& island, Order order);
  /// Solves J M^-1 J' lambda = b - J f; `x` are f + M^-1 J' lambda, three for each cube of the
  /// island, `multiplier` lambda. False where rows depend on one another: then neither is known.
  bool solve(std::vector<double>& x, std::vector<double>& multiplier);

 private:
  using Triple = std::array<double, 3>;
  /// Coefficients on the cube of the corner and on that of the side, by their numbers in the
  /// island; -1 for what is fixed.
  struct Row {
    int on = -1;
    int from = -1;
    Triple g_on{};
    Triple g_from{};
    double bound = 0.0;
  };
  void add(const System& system,
           const State& state,
           const Island& island,
           const Contact& contact,
           Order order);
  [[nodiscard]] double product(const Row& row, const std::vector<double>& x) const;
  [[nodiscard]] double coupling(const Row& a, const Row& b) const;
  bool factorise();
  void substitute(std::array<double, most>& r) const;

  int count_ = 0;
  std::array<Row, most> rows_;
  std::array<double, most * most> factor_{};
  std::array<double, most> inverse_{};  ///< 1 / diagonal
  std::vector<Triple> inverse_mass_;
  std::vector<double> target_;
};

}  // namespace wuerfel
