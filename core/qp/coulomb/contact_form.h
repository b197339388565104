/// A FrictionProgram as its solvers see it, in blocks of three unknowns:
///
///     y = M^(1/2) (x - f),   G = J M^(-1/2),   h = b - J f,   y = G' lambda,   u = G y - h
///
/// Rows are gathered to units: a contact with its normal and tangential row, or a single row. Where
/// a contact has no tangential row or mu = 0 it is a single row, too. Blocks are numbered in the
/// order of elimination.
#pragma once

#include <span>
#include <vector>

#include "core/qp/coulomb/block_lu.h"
#include "core/qp/coulomb/coulomb_residual.h"
#include "core/qp/coulomb/friction_program.h"

namespace wuerfel {

/// Normal and tangential part of something of a unit.
struct Pair {
  double n = 0.0;
  double t = 0.0;
};

struct ContactUnit {
  int first = 0, last = 0;        ///< its entries
  int normal = -1, tangent = -1;  ///< rows of the program; tangent -1: single row
  double mu = 0.0;
  int slides = 0;
  bool equality = false;
  Pair h{};
  Pair square{};        ///< |g|^2; of the largest row for rows of zeros
  Pair compliance{};    ///< |g|^2, of strong friction times mu: that of the force along an edge
  Pair per_velocity{};  ///< slack times this is relative to the largest velocity
  Pair norm{};          ///< multiplier times this is a force
};

/// One block's part of a unit.
struct ContactEntry {
  Quad n, t;
};

/// A change of forces and of what they make of a point and of its rows.
struct ContactStep {
  std::vector<Quad> dy;
  std::vector<Pair> dl, Gdy;
};

class ContactForm {
 public:
  /// Takes over a sound program of blocks of at most three. The order stays if the same blocks are coupled as in the last
  /// one, the pattern if they are so by the same units.
  void prepare(const FrictionProgram& friction, const CoulombScales& scales);
  void forget() { graph_.clear(); }

  [[nodiscard]] int blocks() const { return blocks_; }
  [[nodiscard]] const std::vector<ContactUnit>& units() const { return units_; }
  [[nodiscard]] int count() const { return static_cast<int>(units_.size()); }
  [[nodiscard]] std::span<const ContactEntry> entries(const ContactUnit& unit) const {
    return {entry_.data() + unit.first, entry_.data() + unit.last};
  }
  [[nodiscard]] const int* blocks_of(const ContactUnit& unit) const {
    return block_.data() + unit.first;
  }

  /// out = G y
  void apply(const Quad* y, Pair* out) const;
  /// out = G' l
  void apply_transposed(const Pair* l, Quad* out) const;

  /// Its rows of G y, and its part of G' l added to `out`.
  [[nodiscard]] Pair rows(int unit, const Quad* y) const;
  void add_transposed(int unit, const Pair& l, Quad* out) const;

  /// What a unit adds to K = I + G' C G: its part of C, not symmetric.
  struct Weight {
    double nn = 0.0, nt = 0.0, tn = 0.0, tt = 0.0;
  };
  /// What the dy of a step calls for, dl = C (right - G dy), and out = G' (l + dl) with forces l if there are any.
  void respond(const std::vector<Weight>& weight,
               const std::vector<Pair>& right,
               const std::vector<Pair>* l,
               ContactStep& step,
               Quad* out) const;
  /// K -> factors; false where K is singular.
  bool factorise(const std::vector<Weight>& weight);
  void solve(Quad* v) const { lu_.solve(v); }
  [[nodiscard]] int sign() const { return lu_.sign(); }

  /// x = f + M^(-1/2) y, in the numbering of the program.
  void read(const QuadraticProgram& program,
            const std::vector<Quad>& y,
            std::vector<double>& x) const;
  /// y = M^(1/2) (x - f), the other way round.
  void write(const QuadraticProgram& program,
             const std::vector<double>& x,
             std::vector<Quad>& y) const;
  /// The multipliers of all rows.
  void read(const std::vector<Pair>& l, std::vector<double>& multiplier) const;

 private:
  void gather(const FrictionProgram& friction);
  void plan();
  void find_graph(std::vector<int>& start, std::vector<int>& neighbour) const;
  void place_pairs();
  void find_roots(const QuadraticProgram& p);
  void scale(const FrictionProgram& friction, const CoulombScales& scales);
  void scale_row(const QuadraticProgram& p, int row, bool tangential, ContactUnit& unit);

  BlockLu lu_;
  int blocks_ = 0;
  int rows_ = 0;
  std::vector<ContactUnit> units_;
  std::vector<ContactEntry> entry_;
  std::vector<int> block_;      ///< of the entries: elimination numbers, increasing in a unit
  std::vector<int> pair_;       ///< of each unit: places of (b, a) for entries a <= b
  std::vector<int> graph_;      ///< blocks of the units, as the plan was made for
  std::vector<int> couplings_;  ///< the same of this program
  std::vector<int> start_, neighbour_;  ///< which blocks are coupled, as the order was found for
  std::vector<int> order_, position_;
  std::vector<double> mass_;  ///< that the roots are of
  std::vector<Quad> root_;    ///< M^(-1/2) by elimination number
  std::vector<char> of_contact_;
};

}  // namespace wuerfel
