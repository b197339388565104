/// What happens at an instant: who hits whom, and how the motion goes on.
#pragma once

#include <map>
#include <vector>

#include "core/time/bookkeeping.h"
#include "core/time/events/contact_modes.h"

namespace wuerfel {

struct Instant {
  State state;         ///< just after it
  ContactModes modes;  ///< of the phase that begins
  std::vector<Event> events;
  ContactFinder::Overlap deepest;  ///< that there was
  std::vector<int> contradicting;  ///< rods, where nothing was struck
  Push push;                       ///< by fixed bodies, of its impacts
  Push settled;                    ///< by them, where velocities were put on what stays closed
  std::map<int, Push>
      blows;              ///< N s, of its impacts to bodies that only stand, about their centres
  long skipped_rest = 0;  ///< islands in certified rest
  long skipped_free = 0;  ///< cubes that touch nothing
};

/// The phase that ends at an instant.
struct FormerPhase {
  ContactModes modes;
  bool known = false;  ///< false at the beginning of a motion: nothing is known but who rests
};

/// Moreau's impact over all touching contacts of an island at once, then Gauss' principle for the
/// contacts that do not open. Overlap, which is rounding, is removed, and what stays closed is put
/// on its contacts.
Instant happen(const State& state,
               double t,
               const FormerPhase& before,
               const ContactLimits& limits,
               Workspace& work);

/// Adds events of an impact, one per contact that presses.
void add_impact_events(const System& system,
                       const Island& island,
                       const IslandSolution& impulses,
                       double t,
                       EventKind kind,
                       std::vector<Event>& events);

/// Books the events of an instant, and what was left out.
void note_events(const Instant& now, Bookkeeping& book);
/// Books what of the energy and the momenta of `before` an instant at time t has changed until `after`, where the motion goes on.
void note_change(const System& system,
                 const State& before,
                 double t,
                 const Instant& now,
                 const State& after,
                 Bookkeeping& book);

}  // namespace wuerfel
