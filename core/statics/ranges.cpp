#include "core/statics/ranges.h"

#include <algorithm>
#include <cmath>

#include "core/dynamics/contact_rows.h"
#include "core/dynamics/momentum.h"
#include "core/statics/generators.h"
#include "core/statics/loads.h"

namespace wuerfel {
namespace {

/// A contact opens, or slips, that accelerates by more than this share of g.
constexpr double departing = 1e-8;

double row_value(const ContactRow& row, const Twist& on, const Twist& from) {
  const auto part = [](const std::array<double, 3>& J, const Twist& a) {
    return J[0] * a.linear.x() + J[1] * a.linear.y() + J[2] * a.angular;
  };
  return part(row.on, on) + part(row.from, from);
}

/// The forces of one island that give it the accelerations it has.
class IslandRanges {
 public:
  IslandRanges(const StillScene& still, const IslandForces& of);

  /// Of the sum of normal forces at these contacts, N.
  LoadRange force(const std::vector<int>& contacts);
  /// Of the centre of pressure of these contacts, at `place` (m) each.
  LoadRange center(const std::vector<int>& contacts, const std::vector<double>& place);
  [[nodiscard]] int degree();

 private:
  void drop_what_departs();
  [[nodiscard]] bool may_carry(int row);
  [[nodiscard]] double slip(const Contact& contact) const;
  void balance();
  QuadraticProgram with_block(const std::vector<std::array<double, 3>>& of_rows) const;
  LoadRange sum(const std::vector<double>& of_rows);

  const StillScene& still_;
  const IslandForces& of_;
  Generators generators_;
  std::vector<char>
      used_;           ///< per row: not of a contact that opens, nor of an edge it slips away from
  Load load_;          ///< what the forces carry
  double unit_ = 1.0;  ///< N
  double mass_ = 1.0;  ///< kg
};

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
LoadRange IslandRanges::sum(const std::vector<double>& of_rows) {
  std::vector<std::array<double, 3>> entries(of_rows.size());
  for (std::size_t row = 0; row < of_rows.size(); ++row)
    entries[row][0] = of_rows[row];
  Load w = load_;
  Load q(load_.size(), 0.0);
  w.insert(w.end(), {0.0, 0.0, 0.0});
  q.insert(q.end(), {-unit_, 0.0, 0.0});
  LoadRange range = LoadFactor(with_block(entries)).range(w, q);
  if (is_empty(range)) return range;
  return {range.low * unit_, range.high * unit_, range.error * unit_};
}

LoadRange IslandRanges::force(const std::vector<int>& contacts) {
  std::vector<double> of_rows(used_.size(), 0.0);
  for (std::size_t row = 0; row < used_.size(); ++row) {
    const auto& share = generators_.share[row];
    if (std::ranges::find(contacts, share.contact) != contacts.end()) of_rows[row] = share.normal;
  }
  LoadRange range = sum(of_rows);
  range.low = std::max(range.low, 0.0);
  return range;
}

/// A quotient of two sums. [Charnes, Cooper 1962]: forces and load both times tau >= 0, so that their
/// sum is one; then the moment is the centre.
LoadRange IslandRanges::center(const std::vector<int>& contacts, const std::vector<double>& place) {
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

/// Whether any of the possible forces has a part along a row.
bool IslandRanges::may_carry(int row) {
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

int IslandRanges::degree() {
  std::vector<char> carries(used_.size(), 0);
  int count = 0;
  for (int row = 0; row < generators_.program.rows(); ++row) {
    if (used_[row] == 0 || !may_carry(row)) continue;
    carries[row] = 1;
    ++count;
  }
  if (count == 0) return 0;
  EqualitySolver solver;
  solver.factorise(generators_.program, &carries);
  return solver.dependent_rows();
}

/// The contacts of a face, in an island.
struct Face {
  Interface seen;
  std::vector<int> contacts;
  std::vector<double> place;  ///< m, along the normal turned left, from the middle
};

bool same_face(const Interface& face, const Contact& c) {
  const bool same = face.on == c.on && face.from == c.from && face.normal.dot(c.normal) > 0.0;
  const bool reverse = face.on == c.from && face.from == c.on && face.normal.dot(c.normal) < 0.0;
  return (same || reverse) && std::abs(det(face.normal, c.normal)) <= parallel;
}

std::vector<Face> find_faces(const Island& island) {
  std::vector<Face> faces;
  for (int k = 0; k < static_cast<int>(island.contacts.size()); ++k) {
    const Contact& c = island.contacts[k];
    const auto face =
        std::ranges::find_if(faces, [&](const Face& f) { return same_face(f.seen, c); });
    if (face != faces.end()) {
      face->contacts.push_back(k);
      continue;
    }
    Interface seen;
    seen.on = c.on;
    seen.from = c.from;
    seen.normal = c.normal;
    faces.push_back({seen, {k}, {}});
  }
  for (Face& face : faces) {
    for (const int k : face.contacts)
      face.seen.middle += island.contacts[k].point / static_cast<double>(face.contacts.size());
    for (const int k : face.contacts)
      face.place.push_back(perp(face.seen.normal).dot(island.contacts[k].point - face.seen.middle));
    face.seen.length =
        *std::ranges::max_element(face.place) - *std::ranges::min_element(face.place);
  }
  return faces;
}

/// Resultant and centre of pressure of the forces that are shown.
void add_resultant(const IslandForces& of, Face& face) {
  Interface& seen = face.seen;
  double moment = 0.0;
  double largest = 0.0;
  for (const double f : of.forces.force)
    largest = std::max(largest, f);
  for (std::size_t i = 0; i < face.contacts.size(); ++i) {
    const int k = face.contacts[i];
    seen.force += of.forces.force[k];
    moment += of.forces.force[k] * face.place[i];
    // Seen from either body the tangential force runs along the normal turned left.
    if (!of.forces.tangential.empty()) seen.tangential += of.forces.tangential[k];
  }
  if (seen.force <= pressing_share * largest) return;
  const double x = moment / seen.force;
  seen.center = seen.middle + x * perp(seen.normal);
  seen.center_range = {x, x, 0.0};
  if (seen.length > 0.0) seen.eccentricity = std::abs(x) / (0.5 * seen.length);
}

bool is_asked(const RangeRequest& request, int on, int from) {
  const auto asked = [&](int body) {
    return std::ranges::find(request.cubes, body) != request.cubes.end();
  };
  return request.cubes.empty() || asked(on) || asked(from);
}

/// Forces of the face that are the only ones possible need no program.
void add_face_ranges(IslandRanges& ranges, bool unique, Face& face) {
  Interface& seen = face.seen;
  seen.force_range = {seen.force, seen.force, 0.0};
  if (unique) return;
  seen.force_range = ranges.force(face.contacts);
  if (seen.length > 0.0) {
    seen.center_range = ranges.center(face.contacts, face.place);
  } else if (seen.force_range.high > 0.0) {
    seen.center_range = {0.0, 0.0, 0.0};
  }
}

void add_island(const StillScene& still,
                const IslandForces& of,
                const RangeRequest& request,
                ForceRanges& result) {
  IslandRanges ranges(still, of);
  const auto is_unique = [&](int k) { return request.skip_unique && of.forces.unique[k] != 0; };
  for (int k = 0; k < static_cast<int>(of.island.contacts.size()); ++k) {
    const Contact& c = of.island.contacts[k];
    const double f = of.forces.force[k];
    result.contacts.push_back(!is_asked(request, c.on, c.from) ? no_load
                              : is_unique(k)                   ? LoadRange{f, f, 0.0}
                                                               : ranges.force({k}));
    result.error = std::max(result.error, result.contacts.back().error);
  }
  for (Face& face : find_faces(of.island)) {
    if (!is_asked(request, face.seen.on, face.seen.from)) continue;
    add_resultant(of, face);
    add_face_ranges(ranges, std::ranges::all_of(face.contacts, is_unique), face);
    result.interfaces.push_back(face.seen);
  }
  if (request.degree) result.degree += ranges.degree();
}

}  // namespace

ForceRanges find_ranges(const StillScene& still, const RangeRequest& request) {
  ForceRanges result;
  for (const IslandForces& of : still.found.islands)
    add_island(still, of, request, result);
  return result;
}

}  // namespace wuerfel
