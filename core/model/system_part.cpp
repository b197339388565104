#include "core/model/system_part.h"

#include <algorithm>
#include <utility>

namespace wuerfel {

System part_of(const System& whole, const std::vector<int>& cubes) {
  System part;
  part.title = whole.title;
  part.gravity = whole.gravity;
  part.cubes = static_cast<int>(cubes.size());
  part.pairs = whole.pairs;
  part.rubs = whole.rubs;
  part.bounces = whole.bounces;
  for (const int cube : cubes)
    part.bodies.push_back(whole.body(cube));
  part.bodies.insert(part.bodies.end(), whole.bodies.begin() + whole.cubes, whole.bodies.end());
  part.points = static_cast<int>(std::ranges::count(part.bodies, BodyKind::point, &Body::kind));
  part.strangers = whole.strangers;
  // Rods join cubes of one part only.
  const auto number_in_part = [&](RodEnd& end) {
    if (end.body < 0) return true;
    const auto at = std::ranges::lower_bound(cubes, end.body);
    if (at == cubes.end() || *at != end.body) return false;
    end.body = static_cast<int>(at - cubes.begin());
    return true;
  };
  for (Rod rod : whole.rods)
    if (number_in_part(rod.i) && number_in_part(rod.j)) part.rods.push_back(std::move(rod));
  return part;
}

System part_on(const System& whole,
               const std::vector<int>& cubes,
               const std::vector<int>& standing,
               const State& state) {
  System part = part_of(whole, cubes);
  std::vector<Body> boxes;
  for (const int cube : standing) {
    Body body = whole.body(cube);
    body.kind = BodyKind::fixed;
    body.stands = true;
    body.box = make_box(state[cube].position, state[cube].angle, body.size);
    boxes.push_back(std::move(body));
  }
  part.bodies.insert(part.bodies.begin() + part.cubes, boxes.begin(), boxes.end());
  set_covers(part);
  return part;
}

}  // namespace wuerfel
