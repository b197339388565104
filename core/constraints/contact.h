/// Contacts: triples (p_i, p_j, p_k) with Eq. (2) = 0, the candidates for active side restrictions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/constraints/neighbours.h"
#include "core/constraints/touch.h"

namespace wuerfel {

/// The share of max(sqrt(g side), |v|) up to which the gap's velocity counts as zero.
inline constexpr double rate_tolerance = 1e-9;

/// What rounding may leave of a gap between bodies at these places, m.
double gap_rounding(const Vec2& a, const Vec2& b);
/// The same between any cubes, m.
double gap_rounding(const State& state);

/// What of a contact stays the same from step to step: bodies of corner and side, and their numbers, as one number in
/// the order of these, not negative.
using ContactId = std::int64_t;
constexpr ContactId contact_id(int on, int from, int corner, int side) {
  constexpr int body_bits = 29;
  static_assert(Box::corners <= 4, "two bits each for corner and side");
  return (((ContactId{on} << body_bits) | from) << 4) | (corner << 2) | side;
}

/// Corner p_k of body `on` at the side (p_i, p_j) of body `from`. Points are given by their arms
/// from the centres, or, on planes and fixed boxes, from the same places with zero velocity.
struct Contact {
  int on = 0;                  ///< body of the corner; the normal points into it
  int from = 0;                ///< body of the side
  int corner = 0;              ///< number of p_k in `on`
  int side = 0;                ///< number of the side in `from`; 0 for a plane
  double gap = 0.0;            ///< m, negative inside
  double slip = 0.0;           ///< m, already slid along perp(normal) when a placement begins
  double alpha = 0.0;          ///< Eq. (5)
  double length = 1.0;         ///< m, |p_j - p_i|
  Vec2 point = Vec2::Zero();   ///< m, p_k
  Vec2 normal = Vec2::Zero();  ///< unit vector perp(p_j - p_i) / |p_j - p_i|
  Vec2 arm_k = Vec2::Zero();   ///< m, p_k from the centre of `on`
  Vec2 arm_i = Vec2::Zero();   ///< m, p_i from the centre of `from`
  Vec2 arm_j = Vec2::Zero();   ///< m, p_j from the centre of `from`

  /// What stays the same from step to step.
  [[nodiscard]] ContactId id() const { return contact_id(on, from, corner, side); }
};

/// What stays the same of contacts, ascending.
std::vector<ContactId> sorted_ids(std::span<const Contact> contacts);

/// Velocities of the three points of a contact.
struct ContactVelocity {
  Vec2 v_i = Vec2::Zero();
  Vec2 v_j = Vec2::Zero();
  Vec2 v_k = Vec2::Zero();
};

ContactVelocity contact_velocity(const System& system, const State& state, const Contact& contact);

/// Rate of the gap, m/s: Eq. (6) with the unit normal.
double gap_rate(const Contact& contact, const ContactVelocity& velocity);

/// max(sqrt(g side), |v|), by which the rates of a contact are measured, m/s.
double contact_speed(const System& system, const Contact& contact, const ContactVelocity& velocity);

enum class ContactMotion { closing, resting, opening };

/// Eq. (3): closing where the gap's rate is negative (an impact is due), resting where it counts as
/// zero.
ContactMotion contact_motion(const System& system, const State& state, const Contact& contact);

/// Length by which tolerances of two bodies, or of a contact, are measured: their smaller side, m.
double contact_scale(const System& system, int on, int from);
double contact_scale(const System& system, const Contact& contact);

/// The same corner and side at other poses, and the gap alone.
Contact at_poses(const System& system, std::span<const Box> boxes, const Contact& contact);
double gap_at_poses(const System& system, std::span<const Box> boxes, const Contact& contact);

/// Finds contacts. Keeps its memory, nothing else, from call to call.
class ContactFinder {
 public:
  /// All contacts with gap <= `tolerance` times the smaller side (but at least what rounding of the
  /// positions leaves of a gap), in an order that depends on the state only. Also those of
  /// overlapping pairs, whose gaps are then negative. Rules of the manifold: design, section 1.
  std::vector<Contact> find(const System& system,
                            const State& state,
                            double tolerance = touching_tolerance);

  /// Who touches whom and how, in the order of the contacts that the last `find` found.
  [[nodiscard]] const std::vector<Touch>& touches() const { return touches_; }
  /// Boxes posed by the last `find`.
  [[nodiscard]] std::span<const Box> boxes() const { return boxes_; }
  /// Deepest overlap seen by the last `find`, m; 0 where there is none.
  struct Overlap {
    double depth = 0.0;
    double scale = 1.0;  ///< m, the smaller side of the pair
  };
  [[nodiscard]] const Overlap& deepest() const { return deepest_; }

 private:
  void find_between_boxes(const System& system,
                          const State& state,
                          double tolerance,
                          std::vector<Contact>& contacts);
  void find_on_planes(const System& system, double tolerance, std::vector<Contact>& contacts);
  void note(double separation, double scale);

  std::vector<Box> boxes_;
  Neighbours neighbours_;
  std::vector<Touch> touches_;
  Overlap deepest_;
};

}  // namespace wuerfel
