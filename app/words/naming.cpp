#include "app/words/naming.h"

#include <cmath>
#include <numbers>

#include "core/geometry/trig.h"

namespace wuerfel {

namespace {

/// The side of a cube, along one of its axes, that looks down most; of two its own lower one.
Vec2 down_of(const StillScene& still, int cube) {
  constexpr double rounding = 1e-9;
  Vec2 up;
  sin_cos(still.state[cube].angle + 0.5 * std::numbers::pi, up.y(), up.x());
  const double along = up.dot(still.down());
  const double across = perp(up).dot(still.down());
  if (std::abs(across) > std::abs(along) + rounding) return across > 0.0 ? perp(up) : -perp(up);
  return along > 0.0 ? up : -up;
}

}  // namespace

std::vector<std::string> names_of(const StillScene& still, const std::vector<int>& bodies) {
  std::vector<std::string> names;
  names.reserve(bodies.size());
  for (const int body : bodies)
    names.push_back(still.system.body(body).name);
  return names;
}

std::string part_name(const StillScene& still,
                      const std::vector<int>& cubes,
                      int base,
                      Language language) {
  if (cubes.size() <= most_names) return list_in(language, names_of(still, cubes));
  return say_in(
      language, Phrase::with_many,
      {{"body", still.system.body(base).name}, {"count", std::to_string(cubes.size() - 1)}});
}

std::string side_name(int sense, Language language) {
  return say_in(language, sense < 0 ? Phrase::left : Phrase::right);
}

std::string way_name(int sense, Language language) {
  return say_in(language, sense < 0   ? Phrase::to_the_left
                          : sense > 0 ? Phrase::to_the_right
                                      : Phrase::downwards);
}

Phrase direction_of(const StillScene& still, const Vec2& v) {
  const double right = v.dot(still.right());
  const double down = v.dot(still.down());
  if (std::abs(right) > std::abs(down))
    return right > 0.0 ? Phrase::to_the_right : Phrase::to_the_left;
  return down > 0.0 ? Phrase::downwards : Phrase::upwards;
}

Phrase corner_of(const StillScene& still, int cube, const Vec2& point) {
  const Vec2 arm = point - still.state[cube].position;
  const Vec2 down = down_of(still, cube);
  const bool right = arm.dot(perp(down)) > 0.0;
  if (arm.dot(down) > 0.0) return right ? Phrase::lower_right : Phrase::lower_left;
  return right ? Phrase::upper_right : Phrase::upper_left;
}

}  // namespace wuerfel
