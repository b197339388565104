/// Who may meet whom within a step, and by which corners and sides.
#pragma once

#include <vector>

#include "core/constraints/manifold.h"
#include "core/constraints/neighbours.h"

namespace wuerfel {

class NearContacts {
 public:
  explicit NearContacts(const System& system) : system_(&system) {}

  /// A step of `h` s begins at `state`; `gravity` (m/s^2) bounds how sides may turn to each other
  /// within it.
  void begin(const State& state, double h, double gravity);

  /// Contacts of all pairs that come nearer to each other than `reach` (a share of the smaller
  /// side) on the way from the beginning to `end`: each pair by the side that keeps it apart
  /// longest. Their gaps and arms are those of the beginning.
  std::vector<Contact> find_towards(const State& end, double reach);
  /// The same pairs and sides with corners, gaps and arms as they are at `end`, of every box.
  std::vector<Contact> find_at(std::span<const Box> end, double reach);
  /// Boxes at the beginning, and where the last search looked.
  [[nodiscard]] const std::vector<Box>& start_boxes() const { return start_; }
  [[nodiscard]] const std::vector<Box>& end_boxes() const { return end_; }

 private:
  std::vector<Contact> find(double reach, const std::vector<Box>& measured);
  void add_planes(double reach,
                  const std::vector<Box>& measured,
                  std::vector<Contact>& contacts) const;
  void add_corners(int cube,
                   int plane,
                   double reach,
                   const std::vector<Box>& measured,
                   std::vector<Contact>& contacts) const;

  const System* system_;
  double step_ = 0.0;         ///< s
  double gravity_ = 0.0;      ///< m/s^2
  std::vector<double> spin_;  ///< rad/s at the beginning, of every box
  std::vector<Box> start_;
  std::vector<Box> drift_;  ///< where velocities alone would lead
  std::vector<Box> end_;
  Neighbours neighbours_;
};

}  // namespace wuerfel
