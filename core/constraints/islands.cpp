#include "core/constraints/islands.h"

#include <numeric>

namespace wuerfel {
namespace {

/// Root of a cube, with path halving (Tarjan, van Leeuwen 1984).
int root(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    int& up = parent[i];
    up = parent[up];
    i = up;
  }
  return i;
}

}  // namespace

void find_islands(const System& system,
                  const std::vector<Contact>& contacts,
                  std::vector<Island>& islands) {
  const auto n = static_cast<std::size_t>(system.cubes);
  std::vector<int> parent(n);
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<bool> touched(n, false);
  for (const Contact& c : contacts) {
    for (const int body : {c.on, c.from}) {
      if (system.is_cube(body)) touched[body] = true;
    }
    if (!system.is_cube(c.on) || !system.is_cube(c.from)) continue;
    const int a = root(parent, c.on);
    const int b = root(parent, c.from);
    // The smaller index becomes the root, whatever the order of contacts.
    parent[a > b ? a : b] = a < b ? a : b;
  }
  std::vector<int> number(n, -1);
  std::size_t used = 0;
  for (int i = 0; i < system.cubes; ++i) {
    if (!touched[i]) continue;
    int& k = number[root(parent, i)];
    if (k < 0) {
      k = static_cast<int>(used++);
      if (islands.size() < used) islands.emplace_back();
      islands[k].cubes.clear();
      islands[k].contacts.clear();
    }
    islands[k].cubes.push_back(i);
  }
  islands.resize(used);
  for (const Contact& c : contacts) {
    const int cube = system.is_cube(c.on) ? c.on : c.from;
    const int k = number[root(parent, cube)];
    islands[k].contacts.push_back(c);
  }
}

void one_island(const System& system,
                const std::vector<Contact>& contacts,
                std::vector<Island>& islands) {
  islands.assign(1, {});
  islands[0].cubes.resize(system.cubes);
  std::iota(islands[0].cubes.begin(), islands[0].cubes.end(), 0);
  islands[0].contacts = contacts;
}

void add_free_cubes(const System& system, std::vector<Island>& islands) {
  std::vector<bool> taken(system.cubes, false);
  for (const Island& island : islands) {
    for (const int cube : island.cubes)
      taken[cube] = true;
  }
  for (int i = 0; i < system.cubes; ++i) {
    if (!taken[i]) islands.push_back({{i}, {}});
  }
}

}  // namespace wuerfel
