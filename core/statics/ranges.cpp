#include "core/statics/ranges.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/dynamics/contact_rows.h"
#include "core/dynamics/momentum.h"
#include "core/statics/island_ranges.h"

namespace wuerfel {
namespace {

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
  // Forces that are the only ones possible are not asked for again.
  const auto is_unique = [&](int k) { return of.forces.unique[k] != 0; };
  for (int k = 0; k < static_cast<int>(of.island.contacts.size()); ++k) {
    const Contact& c = of.island.contacts[k];
    const double f = of.forces.force[k];
    result.contacts.push_back(!is_asked(request, c.on, c.from) ? no_load
                              : is_unique(k)                   ? LoadRange{f, f, 0.0}
                                                               : ranges.force({k}));
    result.error = std::max(result.error, result.contacts.back().error);
  }
  std::vector<Face> faces = find_faces(of.island);
  for (Face& face : faces) {
    if (!is_asked(request, face.seen.on, face.seen.from)) continue;
    add_resultant(of, face);
    add_face_ranges(ranges, std::ranges::all_of(face.contacts, is_unique), face);
    result.interfaces.push_back(face.seen);
  }
  if (!request.degree) return;
  std::vector<std::vector<int>> contacts;
  contacts.reserve(faces.size());
  for (Face& face : faces)
    contacts.push_back(std::move(face.contacts));
  result.degree += ranges.degree(contacts);
}

}  // namespace

ForceRanges find_ranges(const StillScene& still, const RangeRequest& request) {
  ForceRanges result;
  for (const IslandForces& of : still.found.islands)
    add_island(still, of, request, result);
  return result;
}

}  // namespace wuerfel
