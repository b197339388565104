#include "core/time/reference/grid_point.h"

#include <algorithm>

namespace wuerfel {

bool GridPoint::at_rest() const {
  return std::ranges::all_of(resting, [](char r) { return r != 0; });
}

void add_pressed(const Island& island,
                 const IslandSolution& solution,
                 std::vector<Contact>& pressed) {
  const double least = solution.least_pressing();
  for (std::size_t k = 0; k < island.contacts.size(); ++k) {
    if (solution.forces[k] > least) pressed.push_back(island.contacts[k]);
  }
}

}  // namespace wuerfel
