/// A step of time stepping while it is taken: where it leads from, and the impulses of its contacts.
#pragma once

#include <map>
#include <vector>

#include "core/dynamics/gauss.h"
#include "core/model/scales.h"

namespace wuerfel {

/// Gaps of up to this share of the smaller side are closed at both ends of a step.
inline constexpr double touching_share = 1e-8;
/// Closing speeds beyond this many g h are impacts, not the load of a step.
inline constexpr double impact_steps = 0.5;

/// Closing speeds and changes of velocity within a step that exceed so many g h make it rough: an impact, and of
/// order one.
inline constexpr double rough_steps = 3.0;

/// Contacts that were pressed take part in the velocity program up to this share of the smaller side.
inline constexpr double pressed_share = 1e-3;
/// Rods may contradict each other that a placement leaves farther off their lengths than this share of them.
inline constexpr double jammed_share = 1e-10;

/// A contact that acts in a step, and its impulses (N s) on the body of the corner, of both halves.
struct Blow {
  Contact start;  ///< as it is at the start of the step
  Contact end;    ///< where the cubes have come
  Vec2 first = Vec2::Zero();
  Vec2 second = Vec2::Zero();
  bool cleaned = false;     ///< the clean-up moved what it joins
  bool taken_back = false;  ///< the second holds what took the first back where the cubes have come
  [[nodiscard]] bool acts() const { return !first.isZero(0.0) || !second.isZero(0.0); }
};

struct Stride {
  double h = 0.0;  ///< s
  Scales scales;
  State start;
  State half;    ///< the start with the velocities between the halves
  State before;  ///< the end with the velocities before the second impulses
  std::map<ContactId, Blow> blows;
  std::vector<double> rods_first{};   ///< N s, per rod of the system, on place i, of the first half
  std::vector<double> rods_second{};  ///< likewise, of the second
  std::vector<int> jammed{};          ///< rods of islands that no placement led to their lengths
};

/// Contacts that have not acted so far enter the stride, whose bodies were at `start_boxes`.
void add_blows(const System& system,
               const std::vector<Box>& start_boxes,
               const std::vector<Contact>& contacts,
               Stride& stride);
/// Contacts that act in either half, as they are at the end.
std::vector<Contact> acting(const Stride& stride);

/// How fast the contact closes at the start, in units of g h.
double closing_speed(const System& system, const Stride& stride, const Contact& contact);

/// Whether the gap is nearer to closed than a share of the smaller side, and the corner within the
/// side.
bool is_near(const System& system, const Contact& contact, double share);

}  // namespace wuerfel
