/// Contact modes: which contacts stay closed after an event, and which open.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/model/scales.h"
#include "core/time/events/event_function.h"
#include "core/time/workspace.h"

namespace wuerfel {

/// Share of the largest force, or of the weight, that rounding leaves of others.
inline constexpr double force_rounding = 1e-11;
/// What is slower than this share of V does not bounce: it would rise by 5e-9 of the size, not much more than what counts
/// as touching. Where forces balance it rests at the end of a stepping, and of a series of bounces.
inline constexpr double slowest_motion = 1e-4;

/// The smooth phase that follows an event.
struct ContactModes {
  ContactSet closed;            ///< rows of contacts that stay closed, of cubes that move
  std::vector<char> resting;    ///< per cube: certified, v = 0 and a = 0
  std::vector<Touch> touching;  ///< all that touches when the phase begins, closed or not
  /// No accelerations keep the contacts closed: cubes turn in a place that fits them exactly. Only
  /// positions know what happens next.
  bool wedged = false;
};

/// What counts as touching and as still.
struct ContactLimits {
  double touching = event_touching;  ///< share of the smaller side up to which bodies touch
  double rest_speed = 1e-9;  ///< share of V below which cubes rest where their forces balance
};

/// What a closed touch that rubs does along its side.
struct SideMode {
  bool sticks = false;
  int slips = 0;      ///< +1, -1 along perp(normal)
  bool idle = false;  ///< slips, and needs no force to stay closed
};

struct IslandModes {
  std::vector<char> closed;     ///< one per contact of the island
  std::vector<SideMode> sides;  ///< one per touch of the island
  bool wedged = false;
};

/// Islands of what touches at a state, up to a share of the smaller side.
std::vector<Island> islands_at(const State& state, double touching, Workspace& work);

/// The contacts of an island that neither open nor close, as inequalities.
std::vector<SideUse> resting_uses(const System& system, const State& state, const Island& island);

/// Accelerations of an island under them.
IslandSolution accelerations_at(const Island& island, const State& state, Workspace& work);

/// Contacts of an island that stay closed under Gauss' principle over those that do not open. Where
/// a force and the gap's acceleration both vanish (the instant of a release), the program is asked
/// again a moment later, where one of them has a sign. `after_impact`: velocities have just jumped;
/// what opens slowly then, and is pressed, is closed at once.
IslandModes find_modes(const Island& island,
                       const State& state,
                       const Scales& scales,
                       bool after_impact,
                       Workspace& work);

/// Leaves those open that slip and need no force to stay closed; false where there are none.
bool drop_idle(ContactSet& closed);

/// Whether an island whose cubes are as slow as `limits` say rests: standing still it stays.
bool rests(const Island& island,
           const State& state,
           const Scales& scales,
           const ContactLimits& limits,
           Workspace& work);
/// Whether all islands of a state do, and nothing falls.
bool would_rest(const State& state, const ContactLimits& limits, Workspace& work);

/// Whether a gap of the pairs that `closed` joins would open with more than `most` m/s^2 if it
/// could, at a state on these contacts. Loads of redundant contacts are not the only ones: a
/// negative one is no release where others would do the same; Gauss' program with inequalities
/// knows.
bool would_open(const State& state, std::span<const Touch> closed, double most, Workspace& work);
/// The same where contacts rub: whether a gap would open, or what sticks would slip.
bool would_let_go(const State& state, const ContactSet& closed, double most, Workspace& work);

/// Whether accelerations under closed contacts have forces that Coulomb's law allows, whatever those of least squares are. `most`:
/// what they may miss, relative to the largest acceleration.
bool have_lawful_forces(const State& state,
                        const ContactSet& closed,
                        const std::function<Twist(int cube)>& acceleration,
                        double most,
                        Workspace& work);

}  // namespace wuerfel
