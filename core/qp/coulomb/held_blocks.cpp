#include "core/qp/coulomb/held_blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/qp/coulomb/rest_program.h"

namespace wuerfel {
namespace {

/// Some blocks of a program, with the rows between them and what stays at zero.
class PartOfProgram {
 public:
  /// `with_row` says of each row whether it belongs to the part.
  PartOfProgram(const FrictionProgram& whole,
                std::span<const char> with_block,
                const std::vector<char>& with_row)
      : whole_(&whole) {
    const QuadraticProgram& p = whole.program;
    program_.clear(p.block_size);
    std::vector<int> number(p.blocks(), -1);
    for (int b = 0; b < p.blocks(); ++b) {
      if (with_block[b] == 0) continue;
      block_.push_back(b);
      const int first = b * p.block_size;
      number[b] = program_.add_block(std::span(p.mass).subspan(first, p.block_size),
                                     std::span(p.target).subspan(first, p.block_size));
    }
    std::vector<int> row_number(p.rows(), -1);
    for (int row = 0; row < p.rows(); ++row) {
      if (with_row[row] == 0) continue;
      row_.push_back(row);
      row_number[row] = program_.add_row(p.bound[row], p.force_min[row], p.force_max[row]);
      for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e)
        if (number[p.entry_block[e]] >= 0) program_.add_entry(number[p.entry_block[e]], p.entry(e));
    }
    for (FrictionContact contact : whole.contacts) {
      if (with_row[contact.normal] == 0) continue;
      contact.normal = row_number[contact.normal];
      if (contact.tangent >= 0) contact.tangent = row_number[contact.tangent];
      contacts_.push_back(contact);
    }
  }

  [[nodiscard]] FrictionProgram program() const {
    return {program_, contacts_, whole_->force_unit};
  }
  /// Of the others, that act on the blocks of the part, as targets: `forces` on all unknowns.
  void push(const std::vector<double>& forces) {
    for (std::size_t b = 0; b < block_.size(); ++b) {
      for (int c = 0; c < program_.block_size; ++c) {
        const std::size_t i = b * program_.block_size + c;
        program_.target[i] += forces[block_[b] * program_.block_size + c] / program_.mass[i];
      }
    }
  }
  void spread(const std::vector<double>& multiplier, std::vector<double>& of_whole) const {
    for (std::size_t k = 0; k < row_.size(); ++k)
      of_whole[row_[k]] = multiplier[k];
  }
  void spread_unknowns(const std::vector<double>& x, std::vector<double>& of_whole) const {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const std::size_t b = i / program_.block_size;
      of_whole[block_[b] * program_.block_size + i % program_.block_size] = x[i];
    }
  }

 private:
  const FrictionProgram* whole_;
  QuadraticProgram program_;
  std::vector<FrictionContact> contacts_;
  std::vector<int> block_;  ///< numbers in the whole
  std::vector<int> row_;
};

/// Of the largest velocity: a block that moves no faster stays at zero.
constexpr double zero_share = 1e-9;

bool stay_at_zero(const FrictionProgram& friction,
                  std::span<const char> still,
                  const CoulombResult& result) {
  if (result.status != QpStatus::optimal) return false;
  const double most = zero_share * CoulombJudge().measure_scales(friction.program).velocity;
  for (int i = 0; i < friction.program.unknowns(); ++i) {
    const double size = std::abs(result.x[i]) * friction.program.unit(i);
    if (still[i / friction.program.block_size] != 0 && size > most) return false;
  }
  return true;
}

}  // namespace

void let_stand(const FrictionProgram& friction,
               std::span<const char> still,
               CoulombResult& result) {
  const auto marked = std::ranges::count_if(still, [](char s) { return s != 0; });
  if (marked == 0 || marked == std::ssize(still) || stay_at_zero(friction, still, result)) return;
  std::optional<CoulombResult> standing = solve_holding(friction, still);
  if (!standing) return;
  standing->factorisations += result.factorisations;
  result = std::move(*standing);
}

std::optional<CoulombResult> solve_holding(const FrictionProgram& friction,
                                           std::span<const char> held) {
  const QuadraticProgram& p = friction.program;
  std::vector<char> free(held.size());
  std::ranges::transform(held, free.begin(), [](char h) { return static_cast<char>(h == 0); });
  std::vector<char> row_of_free(p.rows());
  std::vector<char> row_of_held(p.rows());
  for (int row = 0; row < p.rows(); ++row) {
    row_of_free[row] = std::ranges::any_of(p.blocks_of(row), [&](int b) { return held[b] == 0; });
    row_of_held[row] = row_of_free[row] == 0;
  }
  CoulombResult result;
  result.x.assign(p.unknowns(), 0.0);
  result.multiplier.assign(p.rows(), 0.0);
  const PartOfProgram moving(friction, free, row_of_free);
  CoulombResult moved;
  CoulombSolver().solve(moving.program(), moved);
  if (moved.status != QpStatus::optimal) return {};
  moving.spread(moved.multiplier, result.multiplier);
  moving.spread_unknowns(moved.x, result.x);
  std::vector<double> forces(p.unknowns(), 0.0);
  for (int row = 0; row < p.rows(); ++row)
    p.add_row_force(row, result.multiplier[row], forces);
  PartOfProgram standing(friction, held, row_of_held);
  standing.push(forces);
  const RestResult rest = RestProgram().solve(standing.program());
  if (!rest.equilibrium()) return {};
  standing.spread(rest.multiplier, result.multiplier);
  result.stage = moved.stage;
  result.factorisations = moved.factorisations;
  result.residual = coulomb_residual(friction, result.x, result.multiplier);
  if (result.residual.worst() > CoulombSettings{}.tolerance) return {};
  result.status = QpStatus::optimal;
  return result;
}

}  // namespace wuerfel
