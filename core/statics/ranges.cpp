#include "core/statics/ranges.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/dynamics/contact_rows.h"
#include "core/dynamics/momentum.h"
#include "core/statics/island_ranges.h"
#include "core/work_in_order.h"

namespace wuerfel {
namespace {

/// By this share of its face a centre of pressure may miss the range of all.
constexpr double center_rounding = 1e-8;

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
  for (std::size_t i = 0; i < face.contacts.size(); ++i) {
    const int k = face.contacts[i];
    seen.force += of.forces.force[k];
    moment += of.forces.force[k] * face.place[i];
    // Seen from either body the tangential force runs along the normal turned left.
    if (!of.forces.tangential.empty()) seen.tangential += of.forces.tangential[k];
  }
  if (seen.force <= of.forces.least_pressing()) return;
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

/// Programs that do not depend on one another, and how many of them are done.
class RangeWork {
 public:
  RangeWork(const RangeRequest& request, std::size_t all)
      : workforce_{request.threads, {}}, all_(static_cast<double>(all)) {
    if (request.progress)
      workforce_.pulse = [this, &request] { request.progress(std::min(1.0, done_ / all_)); };
  }

  /// work(i) of i = 0 .. count - 1, in order.
  template <class Work>
  auto each(std::size_t count, Work work) {
    constexpr std::size_t few = 64;  // a crew would take longer than they do
    Workforce workforce = workforce_;
    if (count < few) workforce.threads = 1;
    return work_on_each(workforce, static_cast<int>(count), [&](int i) {
      auto result = work(i);
      ++done_;
      return result;
    });
  }

 private:
  Workforce workforce_;
  double all_;
  std::atomic<int> done_ = 0;
};

/// Forces of the face that are the only ones possible need no program.
Interface with_ranges(const IslandRanges& ranges, bool unique, const Face& face) {
  Interface seen = face.seen;
  seen.force_range = {seen.force, seen.force, 0.0};
  if (unique) return seen;
  seen.force_range = ranges.force(face.contacts, seen.force);
  if (seen.length > 0.0) {
    const LoadRange center = ranges.center(face.contacts, face.place);
    seen.center_range =
        seen.center ? around(seen.center_range.low, center, center_rounding * seen.length) : center;
  } else if (seen.force_range.high > 0.0) {
    seen.center_range = {0.0, 0.0, 0.0};
  }
  return seen;
}

void add_degree(const IslandRanges& ranges,
                const std::vector<Face>& faces,
                RangeWork& work,
                ForceRanges& result) {
  const auto carries = work.each(
      ranges.rows(), [&](int row) { return static_cast<char>(ranges.may_carry(row) ? 1 : 0); });
  std::vector<std::vector<int>> contacts;
  contacts.reserve(faces.size());
  for (const Face& face : faces)
    contacts.push_back(face.contacts);
  result.degree += ranges.degree(carries, contacts);
}

void add_island(const StillScene& still,
                const IslandForces& of,
                const RangeRequest& request,
                RangeWork& work,
                ForceRanges& result) {
  const IslandRanges ranges(still, of);
  // Forces that are the only ones possible are not asked for again.
  const auto is_unique = [&](int k) { return of.forces.unique[k] != 0; };
  const auto of_contact = [&](int k) {
    const Contact& c = of.island.contacts[k];
    const double f = of.forces.force[k];
    if (!is_asked(request, c.on, c.from)) return no_load;
    return is_unique(k) ? LoadRange{f, f, 0.0} : ranges.force({k}, f);
  };
  for (const LoadRange& range : work.each(of.island.contacts.size(), of_contact)) {
    result.contacts.push_back(range);
    result.error = std::max(result.error, range.error);
  }
  const std::vector<Face> faces = find_faces(of.island);
  std::vector<Face> asked;
  for (const Face& face : faces)
    if (is_asked(request, face.seen.on, face.seen.from)) asked.push_back(face);
  for (Face& face : asked)
    add_resultant(of, face);
  const auto of_face = [&](int k) {
    return with_ranges(ranges, std::ranges::all_of(asked[k].contacts, is_unique), asked[k]);
  };
  for (Interface& face : work.each(asked.size(), of_face))
    result.interfaces.push_back(std::move(face));
  if (request.degree) add_degree(ranges, faces, work, result);
}

}  // namespace

ForceRanges find_ranges(const StillScene& still, const RangeRequest& request) {
  ForceRanges result;
  std::size_t contacts = 0;
  for (const IslandForces& of : still.found.islands)
    contacts += of.island.contacts.size();
  // Each contact has a range of its own, a part in that of a face and in the degree.
  RangeWork work(request, 3 * contacts);
  for (const IslandForces& of : still.found.islands)
    add_island(still, of, request, work, result);
  return result;
}

}  // namespace wuerfel
