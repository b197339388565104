#include "core/statics/part_motions.h"

#include <cmath>

#include "core/statics/parts.h"
#include "core/statics/sets.h"

namespace wuerfel {
namespace {

/// A contact closes that does so by more than this share of how far the part reaches.
constexpr double closing = 1e-12;
/// A load whose power is below this share of what it could be has none: rounding of directions.
constexpr double powerless_load = 1e-12;
constexpr std::size_t many_cubes = 128;
constexpr std::size_t few_cubes = 3;

}  // namespace

PartMotions::PartMotions(const StillScene& still,
                         const Island& island,
                         const Generators& generators)
    : still_(&still), island_(&island), mass_(generators.program.mass) {
  for (const std::vector<int>& cubes : carried_parts(still, island)) {
    std::vector<int> places;
    places.reserve(cubes.size());
    for (const int cube : cubes) {
      const auto place = std::ranges::lower_bound(island.cubes, cube) - island.cubes.begin();
      places.push_back(static_cast<int>(place));
    }
    parts_.push_back(std::move(places));
  }
  std::vector<std::vector<int>> rows_of(island.cubes.size());  // by place
  std::vector<int> rods;
  for (int row = 0; row < generators.program.rows(); ++row) {
    if (generators.share[row].contact < 0) {
      rods.push_back(row);
      continue;
    }
    for (int e = generators.program.row_start[row]; e < generators.program.row_start[row + 1]; ++e)
      rows_of[generators.program.entry_block[e]].push_back(row);
  }
  // Of large piles the smallest parts alone: all of them would grow as the square of the pile.
  const bool large = island.cubes.size() > many_cubes;
  for (int part = 0; part < static_cast<int>(parts_.size()); ++part)
    if (!large || parts_[part].size() <= few_cubes) add_of_part(part, generators, rows_of, rods);
}

/// About every contact that holds the part, both ways, and to both sides.
void PartMotions::add_of_part(int part,
                              const Generators& generators,
                              const std::vector<std::vector<int>>& rows_of,
                              const std::vector<int>& rods) {
  const auto inside = [&](int body) {
    const auto at = std::ranges::lower_bound(island_->cubes, body);
    return at != island_->cubes.end() && *at == body
           && has(parts_[part], static_cast<int>(at - island_->cubes.begin()));
  };
  std::vector<int> rows = rods;
  std::vector<int> held;
  for (const int place : parts_[part]) {
    for (const int row : rows_of[place]) {
      const Contact& c = island_->contacts[generators.share[row].contact];
      if (inside(c.on) != inside(c.from)) rows.push_back(row);
    }
  }
  std::ranges::sort(rows);
  for (const int row : rows)
    if (generators.share[row].contact >= 0) add_once(generators.share[row].contact, held);
  for (const double sense : {1.0, -1.0}) {
    for (const int k : held)
      add({part, island_->contacts[k].point, {Vec2::Zero(), sense}}, rows, generators.program);
    add({part, Vec2::Zero(), {sense * still_->right(), 0.0}}, rows, generators.program);
  }
}

Twist PartMotions::of_cube(const Motion& motion, int place) const {
  const Vec2 arm = still_->state[island_->cubes[place]].position - motion.center;
  return {point_velocity(motion.twist, arm), motion.twist.angular};
}

/// Keeps a motion that no row hinders.
void PartMotions::add(const Motion& motion,
                      const std::vector<int>& rows,
                      const QuadraticProgram& program) {
  double reach = 0.0;
  for (const int place : parts_[motion.part])
    reach = std::max(reach, of_cube(motion, place).linear.norm());
  for (const int row : rows) {
    double rate = 0.0;
    for (int e = program.row_start[row]; e < program.row_start[row + 1]; ++e) {
      if (!has(parts_[motion.part], program.entry_block[e])) continue;
      const Twist twist = of_cube(motion, program.entry_block[e]);
      const std::span<const double> J = program.entry(e);
      rate += J[0] * twist.linear.x() + J[1] * twist.linear.y() + J[2] * twist.angular;
    }
    if (rate < -closing * reach || (program.is_equality(row) && rate > closing * reach)) return;
  }
  motions_.push_back(motion);
}

double PartMotions::power(const Motion& motion, const Load& load) const {
  double sum = 0.0;
  for (const int place : parts_[motion.part]) {
    const Twist twist = of_cube(motion, place);
    sum += load[3 * place] * twist.linear.x() + load[3 * place + 1] * twist.linear.y()
           + load[3 * place + 2] * twist.angular;
  }
  return sum;
}

KnownCut PartMotions::cut(const Load& w, const Load& q) const {
  double size = 0.0;  // |M^-1 q|_M^2
  for (std::size_t k = 0; k < q.size(); ++k)
    size += q[k] * q[k] / mass_[k];
  KnownCut best;
  for (const Motion& motion : motions_) {
    const double of_load = power(motion, q);
    if (of_load <= 0.0) continue;
    const double s = -power(motion, w) / of_load;
    if (s >= best.s) continue;
    double square = 0.0;
    for (const int place : parts_[motion.part]) {
      const Twist twist = of_cube(motion, place);
      square += mass_[3 * place] * twist.linear.squaredNorm()
                + mass_[3 * place + 2] * twist.angular * twist.angular;
    }
    const double sharpness = of_load * of_load / (square * size);
    if (sharpness > powerless_load * powerless_load) best = {s, sharpness};
  }
  return best;
}

}  // namespace wuerfel
