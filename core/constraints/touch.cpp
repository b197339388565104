#include "core/constraints/touch.h"

#include <array>

#include "core/constraints/contact.h"

namespace wuerfel {
namespace {

/// Overlaps of flush sides shorter than this share of the side count as one point.
constexpr double no_overlap = 1e-10;

/// Where a contact of a side lies on it, m from p_i.
double along_side(const Contact& c) { return c.alpha * c.length; }

/// The row of a corner at a side, and the one of the next corner.
void add_both_corners(const System& system,
                      std::span<const Box> boxes,
                      const Contact& first,
                      std::vector<Contact>& contacts) {
  Contact next = first;
  next.corner = next_corner(first.corner);
  contacts.push_back(at_poses(system, boxes, first));
  contacts.push_back(at_poses(system, boxes, next));
}

/// What a flush touch bears at the two ends of its overlap.
std::array<double, 2> flush_loads(const Touch& touch,
                                  std::span<const Contact> contacts,
                                  std::span<const double> forces) {
  const double f = forces[touch.first];
  const double g = forces[touch.first + 1];
  const Contact& c = contacts[touch.first];
  const Interval bears = overlap_of(touch, contacts);
  if (bears.length() <= no_overlap * c.length) return {f + g, f + g};
  const double moment = f * along_side(c) + g * along_side(contacts[touch.first + 1]);
  return {((f + g) * bears.high - moment) / bears.length(),
          (moment - (f + g) * bears.low) / bears.length()};
}

}  // namespace

Interval overlap_of(const Touch& touch, std::span<const Contact> contacts) {
  const Contact& c = contacts[touch.first];
  const double s_1 = along_side(c);
  if (touch.kind != Touch::Kind::flush) return {s_1, s_1};
  const double s_2 = along_side(contacts[touch.first + 1]);
  return {std::max(0.0, std::min(s_1, s_2)), std::min(c.length, std::max(s_1, s_2))};
}

double place_along(const System& system, const Contact& contact) {
  const bool on_plane = system.body(contact.from).kind == BodyKind::plane;
  return on_plane ? perp(contact.normal).dot(contact.point) : -along_side(contact);
}

void find_loads(std::span<const Touch> touches,
                std::span<const Contact> contacts,
                std::span<const double> forces,
                std::vector<double>& loads) {
  loads.clear();
  for (const Touch& touch : touches) {
    if (touch.kind == Touch::Kind::flush) {
      for (const double load : flush_loads(touch, contacts, forces))
        loads.push_back(load);
      continue;
    }
    for (int k = touch.first; k < touch.first + touch.count; ++k)
      loads.push_back(forces[k]);
  }
}

void add_closed_rows(const System& system,
                     std::span<const Box> boxes,
                     const Touch& touch,
                     std::span<const Contact> contacts,
                     std::span<const char> closed,
                     ContactSet& rows) {
  Touch kept = touch;
  kept.first = static_cast<int>(rows.contacts.size());
  const bool both = touch.count == 2 && closed[touch.first] != 0 && closed[touch.first + 1] != 0;
  if (touch.kind == Touch::Kind::flush && both) {
    Contact row = contacts[touch.first];
    row.corner = touch.facing;
    if (boxes[row.on].length(touch.facing) > boxes[row.from].length(touch.side)) {
      std::swap(row.on, row.from);
      std::swap(row.corner, row.side);
    }
    add_both_corners(system, boxes, row, rows.contacts);
    kept.facing = row.corner;
  } else {
    for (int k = touch.first; k < touch.first + touch.count; ++k) {
      if (closed[k] != 0) rows.contacts.push_back(contacts[k]);
    }
    if (touch.kind == Touch::Kind::flush) kept.kind = Touch::Kind::corner_on_side;
  }
  kept.count = static_cast<int>(rows.contacts.size()) - kept.first;
  if (kept.count == 0) return;
  kept.on = rows.contacts[kept.first].on;
  kept.from = rows.contacts[kept.first].from;
  kept.side = rows.contacts[kept.first].side;
  rows.touches.push_back(kept);
}

}  // namespace wuerfel
