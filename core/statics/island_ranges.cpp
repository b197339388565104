#include "core/statics/island_ranges.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/contact_rows.h"
#include "core/dynamics/momentum.h"

namespace wuerfel {
namespace {

/// A contact opens, or slips, that accelerates by more than this share of g.
constexpr double departing = 1e-8;

/// What is carried is rounding below this share of the weights.
constexpr double no_load_share = 1e-13;
/// By this share, of the mean weight or of itself, a possible force may miss the range of all.
constexpr double force_rounding = 1e-8;

double row_value(const ContactRow& row, const Twist& on, const Twist& from) {
  const auto part = [](const std::array<double, 3>& J, const Twist& a) {
    return J[0] * a.linear.x() + J[1] * a.linear.y() + J[2] * a.angular;
  };
  return part(row.on, on) + part(row.from, from);
}

}  // namespace

IslandRanges::IslandRanges(const StillScene& still, const IslandForces& of)
    : still_(still),
      of_(of),
      generators_(find_generators(still.system, still.state, of.island, Sliding::given)),
      used_(generators_.program.rows(), 1),
      load_(weights(still, of.island)) {
  const double cubes = static_cast<double>(of.island.cubes.size());
  mass_ = 0.0;
  unit_ = 0.0;
  for (const int cube : of.island.cubes) {
    mass_ += still.system.body(cube).mass / cubes;
    unit_ += still.weight(cube) / cubes;
  }
  if (of.rests) return;
  drop_what_departs();
  balance();
}

/// How fast a contact begins to slip, m/s^2.
double IslandRanges::slip(const Contact& c) const {
  const SideRow row = tangential_row(still_.system, still_.state, c, Order::velocity);
  const ContactRow rigid = pull_back(still_.system, still_.state, c, Order::velocity, row);
  const auto of = [&](int body) {
    return still_.system.is_cube(body) ? still_.found.accelerations[body] : Twist{};
  };
  return row_value(rigid, of(c.on), of(c.from));
}

/// A contact that opens has no force, one that slips the edge against the slip.
void IslandRanges::drop_what_departs() {
  const double g = still_.weight(0) / still_.system.body(0).mass;
  for (std::size_t row = 0; row < used_.size(); ++row) {
    const ForceShare& share = generators_.share[row];
    if (share.contact < 0) continue;
    const bool opens = of_.solution.slacks[share.contact] > departing * g;
    const double slips = slip(of_.island.contacts[share.contact]);
    const bool with_it = share.tangential * slips > 0.0 && std::abs(slips) > departing * g;
    if (opens || with_it) used_[row] = 0;
  }
}

/// What the forces carry: weights less M a, to rounding in the span of the rows that are used.
void IslandRanges::balance() {
  QuadraticProgram& p = generators_.program;
  const auto size_of = [&p](const Load& load) {
    double square = 0.0;
    for (int k = 0; k < p.unknowns(); ++k)
      square += load[k] * load[k] / p.mass[k];
    return std::sqrt(square);
  };
  const double of_weights = size_of(load_);
  for (int k = 0; k < static_cast<int>(of_.island.cubes.size()); ++k) {
    const Twist& a = of_.accelerations[k];
    load_[3 * k] -= p.mass[3 * k] * a.linear.x();
    load_[3 * k + 1] -= p.mass[3 * k + 1] * a.linear.y();
    load_[3 * k + 2] -= p.mass[3 * k + 2] * a.angular;
  }
  for (int k = 0; k < p.unknowns(); ++k)
    p.target[k] = load_[k] / p.mass[k];
  EqualitySolver solver;
  std::vector<double> left;
  std::vector<double> multiplier;
  solver.factorise(p, &used_);
  solver.solve(p, left, multiplier);
  for (int k = 0; k < p.unknowns(); ++k)
    load_[k] -= p.mass[k] * left[k];
  // Of what falls freely in touch rounding is left, which no forces carry.
  if (size_of(load_) <= no_load_share * of_weights) load_.assign(load_.size(), 0.0);
}

/// The rows that are used, with entries on a block more, which measures the forces.
QuadraticProgram IslandRanges::with_block(const std::vector<std::array<double, 3>>& of_rows) const {
  const QuadraticProgram& p = generators_.program;
  QuadraticProgram result;
  result.mass = p.mass;
  result.target.assign(p.target.size(), 0.0);
  const int block = result.add_block(std::array{mass_, mass_, mass_}, std::array{0.0, 0.0, 0.0});
  for (int row = 0; row < p.rows(); ++row) {
    if (used_[row] == 0) continue;
    result.add_row(0.0, p.force_min[row], p.force_max[row]);
    for (int e = p.row_start[row]; e < p.row_start[row + 1]; ++e)
      result.add_entry(p.entry_block[e], p.entry(e));
    if (of_rows[row] != std::array{0.0, 0.0, 0.0}) result.add_entry(block, of_rows[row]);
  }
  return result;
}

/// Of a weighted sum of the forces: the measuring block has to be held by as much.
LoadRange IslandRanges::sum(const std::vector<double>& of_rows) const {
  std::vector<std::array<double, 3>> entries(of_rows.size());
  for (std::size_t row = 0; row < of_rows.size(); ++row)
    entries[row][0] = of_rows[row];
  Load w = load_;
  Load q(load_.size(), 0.0);
  w.insert(w.end(), {0.0, 0.0, 0.0});
  q.insert(q.end(), {-unit_, 0.0, 0.0});
  return LoadFactor(with_block(entries)).range(w, q).times(unit_);
}

LoadRange IslandRanges::force(const std::vector<int>& contacts, double known) const {
  std::vector<double> of_rows(used_.size(), 0.0);
  for (std::size_t row = 0; row < used_.size(); ++row) {
    const auto& share = generators_.share[row];
    if (std::ranges::find(contacts, share.contact) != contacts.end()) of_rows[row] = share.normal;
  }
  LoadRange range = sum(of_rows);
  range.low = std::max(range.low, 0.0);
  return around(known, range, force_rounding * std::max(unit_, known));
}

/// A quotient of two sums. [Charnes, Cooper 1962]: forces and load both times tau >= 0, so that their
/// sum is one; then the moment is the centre.
LoadRange IslandRanges::center(const std::vector<int>& contacts,
                               const std::vector<double>& place) const {
  double length = 0.0;
  for (const double x : place)
    length = std::max(length, std::abs(x));
  std::vector<std::array<double, 3>> entries(used_.size());
  for (std::size_t row = 0; row < used_.size(); ++row) {
    const auto at = std::ranges::find(contacts, generators_.share[row].contact);
    if (at == contacts.end()) continue;
    const double n = generators_.share[row].normal;
    entries[row] = {n, n * place[at - contacts.begin()] / length, 0.0};
  }
  QuadraticProgram program = with_block(entries);
  program.add_inequality(0.0);
  for (int k = 0; k < static_cast<int>(of_.island.cubes.size()); ++k) {
    const double* load = load_.data() + 3 * k;
    program.add_entry(k, std::array{load[0] / unit_, load[1] / unit_, load[2] / unit_});
  }
  Load w(program.mass.size(), 0.0);
  Load q(program.mass.size(), 0.0);
  w[load_.size()] = -unit_;
  q[load_.size() + 1] = -unit_;
  const LoadRange range = LoadFactor(program).range(w, q);
  if (is_empty(range)) return range;
  return {std::max(range.low, -1.0) * length, std::min(range.high, 1.0) * length,
          range.error * length};
}

bool IslandRanges::may_carry(int row) const {
  if (used_[row] == 0) return false;
  const ForceShare& share = generators_.share[row];
  if (share.contact < 0) return true;
  const double N = of_.forces.force[share.contact];
  const double T = of_.forces.tangential.empty() ? 0.0 : of_.forces.tangential[share.contact];
  double largest = 0.0;
  for (const double f : of_.forces.force)
    largest = std::max(largest, f);
  // The edges of a cone share a force: N = n (f + f'), T = t (f - f').
  const double f = share.tangential == 0.0 ? N : 0.5 * (N / share.normal + T / share.tangential);
  if (f > pressing_share * largest) return true;
  if (of_.forces.unique[share.contact] != 0) return false;
  std::vector<double> of_rows(used_.size(), 0.0);
  of_rows[row] = 1.0;
  return sum(of_rows).high > pressing_share * std::max(largest, unit_);
}

int IslandRanges::degree(const std::vector<char>& carries,
                         const std::vector<std::vector<int>>& faces) const {
  std::vector<int> edges(of_.island.contacts.size(), 0);  // that carry
  for (int row = 0; row < rows(); ++row) {
    const int contact = generators_.share[row].contact;
    if (carries[row] != 0 && contact >= 0) ++edges[contact];
  }
  if (std::ranges::count(carries, 1) == 0) return 0;
  EqualitySolver solver;
  solver.factorise(generators_.program, &carries);
  int degree = solver.dependent_rows();
  for (const std::vector<int>& face : faces) {
    const auto sticking = std::ranges::count_if(face, [&](int k) { return edges[k] == 2; });
    degree -= std::max(0, static_cast<int>(sticking) - 1);
  }
  return degree;
}

}  // namespace wuerfel
