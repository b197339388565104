#include "core/statics/parts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/statics/sets.h"

namespace wuerfel {
namespace {

/// A normal with a smaller upward part carries nothing: the side of a neighbour.
constexpr double upright = 1e-9;

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
  double largest = part.mass * g.norm();  // of what falls freely in touch all forces are rounding
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
  const double turn = det(still_->right(), still_->down());
  LoadRange range{unbounded, -unbounded, 0.0};
  for (int row = 0; row < glued.program.rows(); ++row) {
    const std::span<const double> J = glued.program.entry(row);
    const Vec2 n(J[0], J[1]);
    const double up = -n.dot(still_->down());
    if (glued.program.is_equality(row) || !still_->is_level(n) || up <= 0.0) return std::nullopt;
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
  if (between || !weighs) return part;
  if (shift == Shift::of_what_falls && part.stands()) return part;
  // A weight that acts one radius of gyration to the right turns with det(right, down) times itself.
  const double radius = std::sqrt(inertia / part.mass);
  const double turn = det(still_->right(), still_->down());
  const Load q{0.0, 0.0, part.mass * still_->system.gravity.norm() * radius * turn};
  part.shift = LoadFactor(glued.program).range(weight_of(part), q).times(radius);
  return part;
}

}  // namespace wuerfel
