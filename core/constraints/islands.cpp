#include "core/constraints/islands.h"

#include <numeric>

#include "core/geometry/union_find.h"

namespace wuerfel {

void find_islands(const System& system,
                  const std::vector<Contact>& contacts,
                  std::vector<Island>& islands) {
  find_islands(system, contacts, {}, islands);
}

void find_islands(const System& system,
                  const std::vector<Contact>& contacts,
                  std::span<const Touch> touches,
                  std::vector<Island>& islands) {
  UnionFind sets(system.cubes);
  std::vector<char> touched(system.cubes, 0);
  for (const Contact& c : contacts) {
    for (const int body : {c.on, c.from}) {
      if (system.is_cube(body)) touched[body] = 1;
    }
    if (system.is_cube(c.on) && system.is_cube(c.from)) sets.unite(c.on, c.from);
  }
  for (const Rod& rod : system.rods) {
    for (const int body : {rod.i.body, rod.j.body})
      if (body >= 0) touched[body] = 1;
    if (rod.i.body >= 0 && rod.j.body >= 0) sets.unite(rod.i.body, rod.j.body);
  }
  std::vector<int> number(system.cubes, -1);
  int used = 0;
  for (int i = 0; i < system.cubes; ++i) {
    if (touched[i] == 0) continue;
    int& k = number[sets.root(i)];
    if (k < 0) {
      k = used++;
      if (static_cast<int>(islands.size()) < used) islands.emplace_back();
      islands[k].cubes.clear();
      islands[k].contacts.clear();
      islands[k].touches.clear();
      islands[k].rods.clear();
    }
    islands[k].cubes.push_back(i);
  }
  islands.resize(used);
  const auto island_of = [&](int on, int from) -> Island& {
    return islands[number[sets.root(system.is_cube(on) ? on : from)]];
  };
  // Contacts of a touch stay together: they are of the same island.
  std::vector<int> place;
  for (const Contact& c : contacts) {
    Island& island = island_of(c.on, c.from);
    place.push_back(static_cast<int>(island.contacts.size()));
    island.contacts.push_back(c);
  }
  for (int k = 0; k < static_cast<int>(system.rods.size()); ++k) {
    const Rod& rod = system.rods[k];
    const int body = rod.i.body >= 0 ? rod.i.body : rod.j.body;
    islands[number[sets.root(body)]].rods.push_back(k);
  }
  for (const Touch& touch : touches) {
    Island& island = island_of(touch.on, touch.from);
    island.touches.push_back(touch);
    island.touches.back().first = place[touch.first];
  }
}

void one_island(const System& system,
                const std::vector<Contact>& contacts,
                std::vector<Island>& islands) {
  islands.assign(1, {});
  islands[0].cubes.resize(system.cubes);
  std::iota(islands[0].cubes.begin(), islands[0].cubes.end(), 0);
  islands[0].contacts = contacts;
  islands[0].rods.resize(system.rods.size());
  std::iota(islands[0].rods.begin(), islands[0].rods.end(), 0);
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

}  // namespace wuerfel
