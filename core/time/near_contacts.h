/// Who may meet whom within a step, and by which corners and sides.
#pragma once

#include <vector>

#include "core/constraints/contact.h"

namespace wuerfel {

class NearContacts {
 public:
  explicit NearContacts(const System& system) : system_(&system) {}

  /// Looks at a step of `h` s from `start` to where free flight would lead; `gravity` (m/s^2)
  /// bounds how sides may turn to each other meanwhile. Corners and sides are chosen at the start.
  void find(const State& start, const State& predicted, double h, double gravity);

  [[nodiscard]] const std::vector<Contact>& contacts() const { return contacts_; }
  /// Adds a pair of boxes that was not thought to meet.
  void add(const IndexPair& pair, double flush) {
    add_near_contacts(boxes_, pair.first, pair.second, flush, contacts_);
  }
  /// Where free flight would lead.
  [[nodiscard]] const std::vector<Box>& predicted_boxes() const { return predicted_boxes_; }

 private:
  void add_pair(const State& start, const IndexPair& pair, double h, double gravity);
  void add_planes();

  const System* system_;
  std::vector<Box> boxes_;  ///< at the start
  std::vector<Box> predicted_boxes_;
  std::vector<BoundingBox> bounds_;
  BroadPhase broad_phase_;
  std::vector<Contact> contacts_;
};

}  // namespace wuerfel
