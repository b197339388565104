#include "core/constraints/manifold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/constraints/side.h"

namespace wuerfel {
namespace {

/// The other side of a flush pair separates it less well by at most this many times what counts as
/// touching.
constexpr double flush_times = 20.0;

/// Corners of `b` that reach down to the line of side e of `a`.
struct Incident {
  std::array<int, Box::corners> corner{};
  int count = 0;
};

Incident incident_corners(const Box& a, int e, const Box& b, double tolerance) {
  Incident incident;
  const Vec2 n = a.normal(e);
  const double offset = n.dot(b.center - a.center) - a.reach(e);
  for (int k = 0; k < b.corner_count(); ++k) {
    if (offset + n.dot(b.arm[k]) <= tolerance) {
      incident.corner[incident.count++] = k;
    }
  }
  return incident;
}

/// The side of `b` that faces the normal n: the one with the most opposite normal.
int facing_side(const Box& b, const Vec2& n) {
  int best = 0;
  double least = 2.0;
  for (int f = 0; f < Box::corners; ++f) {
    const double along = b.normal(f).dot(n);
    if (along < least) {
      least = along;
      best = f;
    }
  }
  return best;
}

/// Whether two sides lie on each other: both corners of one on the line of the other, whichever of
/// them separates the pair better.
bool is_flush(
    const FacingSide& s, const Box& a, const Box& b, const Incident& on_s, double tolerance) {
  if (on_s.count >= 2) return true;
  const int f = facing_side(b, a.normal(s.side));
  return side_separation(b, f, a) >= s.separation - flush_times * tolerance
         && incident_corners(b, f, a, tolerance).count >= 2;
}

/// Edge on edge: the two ends of the overlap of side e of `from` and side f of `on`; false where it
/// has no length. Each end is a corner of one body on the side of the other.
bool add_face(const FacingSide& s,
              const Box& a,
              const Box& b,
              double tolerance,
              std::vector<Contact>& contacts) {
  const int f = facing_side(b, a.normal(s.side));
  const Vec2 origin = a.corner(next_corner(s.side));
  const Vec2 t = (a.corner(s.side) - origin) / a.length(s.side);
  // Along t: side e covers [0, length]; side f, with opposite sense, from its corner f to corner f
  // + 1.
  const double f_low = t.dot(b.corner(f) - origin);
  const double f_high = t.dot(b.corner(next_corner(f)) - origin);
  const double low = std::max(0.0, f_low);
  const double high = std::min(a.length(s.side), f_high);
  if (high - low <= tolerance) return false;
  contacts.push_back(f_low >= 0.0 ? corner_on_side(s.on, b, f, s.from, a, s.side)
                                  : corner_on_side(s.from, a, next_corner(s.side), s.on, b, f));
  contacts.push_back(f_high <= a.length(s.side)
                         ? corner_on_side(s.on, b, next_corner(f), s.from, a, s.side)
                         : corner_on_side(s.from, a, s.side, s.on, b, f));
  return true;
}

/// The touch of the contacts that have been added last: flush, or of one corner.
Touch touch_of(const std::vector<Contact>& contacts, int count) {
  Touch touch;
  touch.first = static_cast<int>(contacts.size()) - count;
  touch.count = count;
  const Contact& c = contacts[touch.first];
  touch.on = c.on;
  touch.from = c.from;
  touch.side = c.side;
  return touch;
}

/// The same of a flush pair, as its first contact sees it.
Touch flush_touch(const FacingSide& s,
                  std::span<const Box> boxes,
                  const std::vector<Contact>& contacts) {
  Touch touch = touch_of(contacts, 2);
  touch.kind = Touch::Kind::flush;
  touch.facing =
      touch.from == s.from ? facing_side(boxes[s.on], boxes[s.from].normal(s.side)) : s.side;
  return touch;
}

/// Sides that separate a pair: those within tolerance of the largest separation, and of a pair that
/// touches all that touch.
struct Candidates {
  std::array<FacingSide, 2 * Box::corners> list;
  int count = 0;
  double largest = 0.0;
};

Candidates separating_sides(std::span<const Box> boxes, int i, int j, double tolerance) {
  Candidates found;
  const SideSeparations all = side_separations(boxes[i], boxes[j]);
  found.largest = std::ranges::max(all);
  if (found.largest > tolerance) return found;
  const double least = std::min(found.largest, 0.0) - tolerance;
  for (int e = 0; e < 2 * Box::corners; ++e) {
    if (all[e] < least) continue;
    found.list[found.count++] =
        e < Box::corners ? FacingSide{i, j, e, all[e]} : FacingSide{j, i, e - Box::corners, all[e]};
  }
  return found;
}

/// The incident corner of which `size` is least.
template <typename Size>
Contact least_corner(
    const FacingSide& s, const Box& a, const Box& b, const Incident& incident, const Size& size) {
  Contact best = corner_on_side(s.on, b, incident.corner[0], s.from, a, s.side);
  for (int m = 1; m < incident.count; ++m) {
    const Contact c = corner_on_side(s.on, b, incident.corner[m], s.from, a, s.side);
    if (size(c) < size(best)) best = c;
  }
  return best;
}

/// The incident corner that a contact which is not flush is at: of several the one nearest to the middle of the side.
Contact corner_of(const FacingSide& s, const Box& a, const Box& b, const Incident& incident) {
  return least_corner(s, a, b, incident, [](const Contact& c) { return std::abs(c.alpha - 0.5); });
}

/// Corner on corner: of all sides that separate, the one that opens fastest.
struct FastestCorner {
  std::optional<Contact> contact{};
  double rate = 0.0;  ///< m/s, of its gap

  void compare(const System& system, const State& state, const Contact& c) {
    const double here = gap_rate(c, contact_velocity(system, state, c));
    if (contact && here <= rate) return;
    contact = c;
    rate = here;
  }
};

}  // namespace

Contact corner_on_side(int on, const Box& b, int k, int from, const Box& a, int e) {
  Contact c;
  c.on = on;
  c.from = from;
  c.corner = k;
  c.side = e;
  c.normal = a.normal(e);
  c.length = a.length(e);
  c.arm_k = b.arm[k];
  c.arm_i = a.arm[next_corner(e)];
  c.arm_j = a.arm[e];
  c.point = b.center + c.arm_k;
  const Vec2 from_center = (b.center - a.center) + c.arm_k;
  c.gap = side_gap(c.normal, from_center, a.reach(e));
  c.alpha = edge_parameter(c.arm_i, c.arm_j, from_center);
  return c;
}

double add_touching_contacts(const System& system,
                             const State& state,
                             std::span<const Box> boxes,
                             const IndexPair& pair,
                             double tolerance,
                             std::vector<Contact>& contacts,
                             std::vector<Touch>& touches) {
  const Candidates sides = separating_sides(boxes, pair.first, pair.second, tolerance);
  bool flush = false;
  FastestCorner corner;
  for (int m = 0; m < sides.count; ++m) {
    const FacingSide& s = sides.list[m];
    const Box& a = boxes[s.from];
    const Box& b = boxes[s.on];
    const Incident incident = incident_corners(a, s.side, b, tolerance);
    if (is_flush(s, a, b, incident, tolerance)) {
      flush = true;
      if (add_face(s, a, b, tolerance, contacts)) {
        touches.push_back(flush_touch(s, boxes, contacts));
        return sides.largest;
      }
    }
    if (incident.count > 0) corner.compare(system, state, corner_of(s, a, b, incident));
  }
  // Aligned corners of a grid need no contact unless they go into each other.
  const auto closes = [&](const Contact& c) {
    return contact_motion(system, state, c) == ContactMotion::closing;
  };
  if (corner.contact && (!flush || closes(*corner.contact))) {
    contacts.push_back(*corner.contact);
    touches.push_back(touch_of(contacts, 1));
  }
  return sides.largest;
}

Contact deepest_corner_at(std::span<const Box> boxes, int from, int on, int side) {
  const Box& a = boxes[from];
  const Box& b = boxes[on];
  return least_corner({from, on, side, 0.0}, a, b,
                      incident_corners(a, side, b, std::numeric_limits<double>::max()),
                      [](const Contact& c) { return c.gap; });
}

Contact nearest_corner(std::span<const Box> boxes, int i, int j) {
  const Candidates sides = separating_sides(boxes, i, j, std::numeric_limits<double>::max());
  FacingSide best = sides.list[0];
  for (int m = 1; m < sides.count; ++m) {
    const FacingSide& s = sides.list[m];
    if (s.separation > best.separation) best = s;
  }
  return deepest_corner_at(boxes, best.from, best.on, best.side);
}

bool is_covered(const System& system, const Contact& c) {
  const Body& on = system.body(c.on);
  const Body& from = system.body(c.from);
  return (on.cover && on.cover->covers_corner(c.corner))
         || (from.cover && from.cover->covers(c.side, c.alpha));
}

void add_near_contacts(std::span<const Box> boxes,
                       const FacingSide& side,
                       double flush,
                       std::vector<Contact>& contacts) {
  const Box& a = boxes[side.from];
  const Box& b = boxes[side.on];
  const Vec2 n = a.normal(side.side);
  if (std::abs(det(n, b.normal(facing_side(b, n)))) <= flush) {
    if (add_face(side, a, b, touching_tolerance * std::min(a.smaller_side(), b.smaller_side()),
                 contacts))
      return;
  }
  contacts.push_back(deepest_corner_at(boxes, side.from, side.on, side.side));
}

}  // namespace wuerfel
