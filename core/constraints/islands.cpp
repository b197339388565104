#include "core/constraints/islands.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/union_find.h"

namespace wuerfel {
std::vector<int> number_islands(const System& system, std::span<const IndexPair> joined_bodies) {
  UnionFind sets(system.cubes);
  std::vector<int> number(system.cubes, -1);
  constexpr int joined = 0;
  const auto moves = [&](int body) { return body >= 0 && system.is_cube(body); };
  const auto join = [&](int a, int b) {
    if (moves(a)) number[a] = joined;
    if (moves(b)) number[b] = joined;
    if (moves(a) && moves(b)) sets.unite(a, b);
  };
  for (const auto& [a, b] : joined_bodies)
    join(a, b);
  for (const Rod& rod : system.rods)
    join(rod.i.body, rod.j.body);
  std::vector<int> of_root(system.cubes, -1);
  int used = 0;
  for (int cube = 0; cube < system.cubes; ++cube) {
    if (number[cube] != joined) continue;
    int& k = of_root[sets.root(cube)];
    if (k < 0) k = used++;
    number[cube] = k;
  }
  return number;
}

std::vector<Island> find_islands(const System& system,
                                 std::span<const Contact> contacts,
                                 std::span<const Touch> touches) {
  std::vector<IndexPair> joined;
  joined.reserve(contacts.size());
  for (const Contact& c : contacts)
    joined.emplace_back(c.on, c.from);
  const std::vector<int> number = number_islands(system, joined);
  std::vector<Island> islands(number.empty() ? 0 : std::ranges::max(number) + 1);
  for (int cube = 0; cube < system.cubes; ++cube)
    if (number[cube] >= 0) islands[number[cube]].cubes.push_back(cube);
  const auto island_of = [&](int on, int from) -> Island& {
    return islands[number[system.is_cube(on) ? on : from]];
  };
  std::vector<std::size_t> size(islands.size(), 0);
  for (const auto& [on, from] : joined)
    ++size[number[system.is_cube(on) ? on : from]];
  for (std::size_t k = 0; k < size.size(); ++k)
    islands[k].contacts.reserve(size[k]);
  // Contacts of a touch stay together: they are of the same island.
  std::vector<int> place;
  place.reserve(touches.empty() ? 0 : contacts.size());
  for (const Contact& c : contacts) {
    Island& island = island_of(c.on, c.from);
    if (!touches.empty()) place.push_back(static_cast<int>(island.contacts.size()));
    island.contacts.push_back(c);
  }
  for (int k = 0; k < static_cast<int>(system.rods.size()); ++k) {
    const Rod& rod = system.rods[k];
    islands[number[rod.i.body >= 0 ? rod.i.body : rod.j.body]].rods.push_back(k);
  }
  for (const Touch& touch : touches) {
    Island& island = island_of(touch.on, touch.from);
    island.touches.push_back(touch);
    island.touches.back().first = place[touch.first];
  }
  return islands;
}

Island one_island(const System& system, const std::vector<Contact>& contacts) {
  Island all;
  all.cubes.resize(system.cubes);
  std::iota(all.cubes.begin(), all.cubes.end(), 0);
  all.contacts = contacts;
  all.rods.resize(system.rods.size());
  std::iota(all.rods.begin(), all.rods.end(), 0);
  return all;
}

void add_free_cubes(const System& system, std::vector<Island>& islands) {
  std::vector<bool> taken(system.cubes, false);
  for (const Island& island : islands) {
    for (const int cube : island.cubes)
      taken[cube] = true;
  }
  for (int i = 0; i < system.cubes; ++i) {
    if (!taken[i]) islands.push_back({{i}, {}, {}});
  }
}

bool touches_fixed(const System& system, std::span<const Contact> contacts) {
  return std::ranges::any_of(
      contacts, [&](const Contact& c) { return !system.is_cube(c.on) || !system.is_cube(c.from); });
}

bool is_fixed(const System& system, const Island& island) {
  return touches_fixed(system, island.contacts)
         || std::ranges::any_of(island.rods, [&](int rod) { return is_held(system.rods[rod]); });
}

bool all_rest(const Island& island, const std::vector<char>& resting) {
  return std::ranges::all_of(island.cubes, [&](int cube) { return resting[cube] != 0; });
}

}  // namespace wuerfel
