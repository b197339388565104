#include "core/statics/parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/statics/margins.h"

namespace wuerfel {
namespace {

/// A normal with a smaller upward part carries nothing: the side of a neighbour.
constexpr double upright = 1e-9;
constexpr double no_slope = 1e-14;  ///< sine of an angle that rounding leaves
/// A contact closes that does so by more than this share of how far the part reaches.
constexpr double closing = 1e-12;
constexpr std::size_t many_cubes = 128;
constexpr std::size_t few_cubes = 3;

bool has(const std::vector<int>& ascending, int cube) {
  return std::ranges::binary_search(ascending, cube);
}

/// Adds a contact that is not there yet.
void add_once(int contact, std::vector<int>& contacts) {
  if (std::ranges::find(contacts, contact) == contacts.end()) contacts.push_back(contact);
}

/// Who carries whom directly, by number of body; fixed bodies are left out.
std::vector<std::vector<int>> carried_directly(const StillScene& still, const Island& island) {
  std::vector<std::vector<int>> on_top(still.system.cubes);
  for (const Contact& c : island.contacts) {
    const double up = -c.normal.dot(still.down());
    if (std::abs(up) <= upright) continue;
    const int below = up > 0.0 ? c.from : c.on;
    const int above = up > 0.0 ? c.on : c.from;
    if (still.system.is_cube(below) && still.system.is_cube(above)) on_top[below].push_back(above);
  }
  return on_top;
}

}  // namespace

std::vector<std::vector<int>> carried_parts(const StillScene& still, const Island& island) {
  const std::vector<std::vector<int>> on_top = carried_directly(still, island);
  std::vector<std::vector<int>> parts;
  std::vector<int> seen(still.system.cubes, -1);
  for (const int cube : island.cubes) {
    std::vector<int> part{cube};
    seen[cube] = cube;
    for (std::size_t next = 0; next < part.size(); ++next) {
      for (const int above : on_top[part[next]]) {
        if (seen[above] == cube) continue;
        seen[above] = cube;
        part.push_back(above);
      }
    }
    std::ranges::sort(part);
    parts.push_back(std::move(part));
  }
  return parts;
}

PartJudge::PartJudge(const StillScene& still, const Island& island)
    : still_(&still),
      island_(&island),
      generators_(find_generators(still.system, still.state, island, Sliding::given)) {}

/// Whether a row joins the part to itself.
bool PartJudge::is_inner(const PartStand& part, int row) const {
  const int contact = generators_.share[row].contact;
  const auto inside = [&](int body) { return has(part.cubes, body); };
  if (contact >= 0)
    return inside(island_->contacts[contact].on) && inside(island_->contacts[contact].from);
  const QuadraticProgram& p = generators_.program;
  const auto first = p.entry_block.begin() + p.row_start[row];
  const auto last = p.entry_block.begin() + p.row_start[row + 1];
  return last - first > 1
         && std::all_of(first, last, [&](int block) { return inside(island_->cubes[block]); });
}

/// The rows that join the part to the rest, on one block at its centre.
void PartJudge::glue_rows(PartStand& part, Generators& glued) const {
  const QuadraticProgram& p = generators_.program;
  for (int row = 0; row < p.rows(); ++row) {
    std::array<double, 3> sum{};
    int inside = 0;
    for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e) {
      const int cube = island_->cubes[p.entry_block[e]];
      if (!has(part.cubes, cube)) continue;
      ++inside;
      const std::span<const double> J = p.entry(e);
      const Vec2 arm = still_->state[cube].position - part.centre;
      sum[0] += J[0];
      sum[1] += J[1];
      sum[2] += J[2] + det(arm, Vec2(J[0], J[1]));
    }
    if (inside == 0 || is_inner(part, row)) continue;
    if (generators_.share[row].contact < 0) part.on_rods = true;
    glued.program.add_row(0.0, p.force_min[row], p.force_max[row]);
    glued.program.add_entry(0, sum);
    glued.share.push_back(generators_.share[row]);
  }
}

Load PartJudge::weight_of(const PartStand& part) const {
  const Vec2 weight = part.mass * still_->system.gravity;
  return {weight.x(), weight.y(), 0.0};
}

/// How the part would fall, glued, and what presses on it then.
void PartJudge::fall(const Generators& glued, PartStand& part) const {
  QuadraticProgram program = glued.program;
  const Vec2& g = still_->system.gravity;
  program.target = {g.x(), g.y(), 0.0};
  QpResult result;
  make_qp_solver(QpMethod::automatic, {.tolerance = 1e-12})->solve(program, result);
  const Twist a{{result.x[0], result.x[1]}, result.x[2]};
  const double radius = std::sqrt(program.mass[2] / program.mass[0]);
  if (a.linear.norm() + radius * std::abs(a.angular) <= stands_below * g.norm()) return;
  part.motion = a;
  double most = 0.0;
  double largest = 0.0;
  for (const double f : result.multiplier)
    largest = std::max(largest, f);
  for (int row = 0; row < program.rows(); ++row) {
    const double f = result.multiplier[row];
    const int contact = glued.share[row].contact;
    if (contact < 0 || f <= pressing_share * largest) continue;
    add_once(contact, part.presses);
    if (f > most) part.pivot = contact;
    most = std::max(most, f);
  }
  if (radius * std::abs(a.angular) <= stands_below * g.norm())
    part.pivot.reset();  // slides or falls
}

/// Where all forces on the part are parallel to its weight: from the first to the last of them.
std::optional<LoadRange> PartJudge::between_supports(const Generators& glued) const {
  const double turn = det(right_of(still_->down()), still_->down());
  LoadRange range{unbounded, -unbounded, 0.0};
  for (int row = 0; row < glued.program.rows(); ++row) {
    const std::span<const double> J = glued.program.entry(row);
    const Vec2 n(J[0], J[1]);
    const double up = -n.dot(still_->down());
    if (glued.program.is_equality(row) || std::abs(det(n, still_->down())) > no_slope * n.norm()
        || up <= 0.0)
      return std::nullopt;
    const double place = -J[2] / up / turn;
    range.low = std::min(range.low, place);
    range.high = std::max(range.high, place);
  }
  return range;
}

PartStand PartJudge::judge(const std::vector<int>& cubes, Shift shift) const {
  PartStand part;
  part.cubes = cubes;
  double inertia = 0.0;
  for (const int cube : cubes) {
    const double m = still_->system.body(cube).mass;
    part.mass += m;
    part.centre += m * still_->state[cube].position;
  }
  part.centre /= part.mass;
  for (const int cube : cubes) {
    const Body& body = still_->system.body(cube);
    inertia +=
        body.inertia + body.mass * (still_->state[cube].position - part.centre).squaredNorm();
  }
  Generators glued;
  glued.program.mass = {part.mass, part.mass, inertia};
  glued.program.target.assign(3, 0.0);
  glue_rows(part, glued);
  for (const ForceShare& share : glued.share) {
    if (share.contact >= 0) add_once(share.contact, part.held_by);
  }
  const bool weighs = !still_->system.gravity.isZero(0.0);
  const std::optional<LoadRange> between = weighs ? between_supports(glued) : std::nullopt;
  if (!between || !between->contains(0.0)) fall(glued, part);
  if (between) part.shift = *between;
  if (between || shift == Shift::ignored || !weighs) return part;
  if (shift == Shift::of_what_falls && part.stands()) return part;
  // A weight that acts one radius of gyration to the right turns with det(right, down) times itself.
  const double radius = std::sqrt(inertia / part.mass);
  const double turn = det(right_of(still_->down()), still_->down());
  const Load q{0.0, 0.0, part.mass * still_->system.gravity.norm() * radius * turn};
  part.shift = LoadFactor(glued.program).range(weight_of(part), q);
  if (is_empty(part.shift)) return part;
  part.shift.low *= radius;
  part.shift.high *= radius;
  return part;
}

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
    add({part, Vec2::Zero(), {sense * right_of(still_->down()), 0.0}}, rows, generators.program);
  }
}

Twist PartMotions::of_cube(const Motion& motion, int place) const {
  const Vec2 arm = still_->state[island_->cubes[place]].position - motion.center;
  return {motion.twist.linear + motion.twist.angular * perp(arm), motion.twist.angular};
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
    best = {s, of_load * of_load / (square * size)};
  }
  return best;
}

}  // namespace wuerfel
