/// "Bestimme die aktiven Restriktionen": what touches at a grid point, the impacts that are due there
/// (the paper has no law for them), and what rests.
#pragma once

#include "core/constraints/contact.h"
#include "core/time/bookkeeping.h"
#include "core/time/reference/grid_point.h"

namespace wuerfel {

class ActiveRestrictions {
 public:
  ActiveRestrictions(const System& system, const MotionSettings& settings);

  /// Contacts of a state that was just reached, and its impacts. `point` still has the contacts of
  /// the grid time before.
  void find(GridPoint& point, Bookkeeping& book);
  /// "Bestimme (a_i)": Eq. (9) under (1), and under (7) where (2) = (3) = 0; once for each point.
  void accelerate(GridPoint& point, Bookkeeping& book);
  [[nodiscard]] IslandDynamics& dynamics() { return dynamics_; }

 private:
  void group(const std::vector<Contact>& contacts, std::vector<Island>& islands) const;
  static void keep_rest(GridPoint& point, const GridPoint& before);
  void strike(GridPoint& point,
              const Island& island,
              const std::vector<ContactId>& lasting,
              Bookkeeping& book);
  void jam(GridPoint& point,
           const Island& island,
           bool struck,
           const std::vector<int>& jammed,
           Bookkeeping& book) const;
  void stop_what_hardly_moves(const Island& island, State& state) const;

  const System* system_;
  Skips skips_;
  IslandDynamics dynamics_;
  ContactFinder finder_;
};

}  // namespace wuerfel
