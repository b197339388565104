/// The system of cubes (System von Würfeln): what does not change while it moves.
#pragma once

#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/box.h"
#include "core/model/cover.h"
#include "core/model/rod.h"
#include "core/model/state.h"
#include "core/scene/overlap.h"
#include "core/scene/scene.h"

namespace wuerfel {

struct Body {
  std::string name;
  BodyKind kind = BodyKind::cube;
  Vec2 size = Vec2::Zero();  ///< m; of boxes
  double mass = 0.0;         ///< kg; of cubes and points
  /// kg m^2, m (w^2 + h^2) / 12 about the centre; of cubes. Points never turn: m times a square metre,
  /// so that their block of a program has the form of the others.
  double inertia = 0.0;
  Box box;                      ///< pose of a fixed box
  Vec2 point = Vec2::Zero();    ///< m; of planes
  Vec2 normal = Vec2::UnitY();  ///< unit vector out of the solid; of planes
  Material material;
  std::shared_ptr<const Cover> cover;  ///< of a fixed box that others touch; else none
  bool stands =
      false;       ///< a fixed box that is a cube of the scene, as long as forces hold it (part_on)
  int number = 0;  ///< in the whole scene, also where only a part of its cubes is looked at

  /// Distance of the corners from the centre, m; of boxes.
  [[nodiscard]] double radius() const { return 0.5 * size.norm(); }
  [[nodiscard]] int corner_count() const { return kind == BodyKind::point ? 1 : Box::corners; }
  double reach = 0.0;  ///< m, of points: what stands for a side where lengths are compared
  /// Length by which tolerances of a body are measured, m; without bound for a plane.
  [[nodiscard]] double smaller_side() const {
    if (kind == BodyKind::point) return reach;
    return kind == BodyKind::plane ? std::numeric_limits<double>::max() : size.minCoeff();
  }
};

/// Bodies are numbered: cubes first, in the order of the scene, then points, fixed boxes, planes.
struct System {
  std::string title;
  Vec2 gravity = Vec2::Zero();  ///< m/s^2
  std::vector<Body> bodies;
  int cubes = 0;  ///< bodies that move: points are cubes without size

  [[nodiscard]] const Body& body(int i) const { return bodies[i]; }
  [[nodiscard]] bool is_cube(int i) const { return i < cubes; }
  [[nodiscard]] int count() const { return static_cast<int>(bodies.size()); }

  /// Surfaces of pairs that the scene names, by Body::number, the smaller first.
  std::map<std::pair<int, int>, Material> pairs;
  bool rubs = false;     ///< whether any pair has friction
  bool bounces = false;  ///< whether any pair has restitution
  /// Friction and restitution of two bodies: what the scene says of the pair, else the geometric
  /// means of their own.
  [[nodiscard]] Material surface(int i, int j) const;

  std::vector<Rod> rods;  ///< of the scene, between bodies and to what is fixed; in its order
  int points = 0;         ///< bodies that are point masses, the last ones that move
  /// Pairs, by Body::number, the smaller first, that pass through each other: pins join them.
  std::set<std::pair<int, int>> strangers;
  /// Whether bodies may touch: points don't touch points.
  [[nodiscard]] bool may_touch(int i, int j) const;
  /// Whether all bodies that are neighbours may touch.
  [[nodiscard]] bool all_may_touch() const { return points == 0 && strangers.empty(); }
};

System make_system(const Scene& scene);

/// Finds what fixed bodies cover of one another.
void set_covers(System& system);

/// The state that the scene starts from.
State initial_state(const Scene& scene);

/// Poses of all boxes, cubes and fixed, numbered as bodies; planes have an empty box.
void pose_boxes(const System& system, const State& state, std::vector<Box>& boxes);

/// Largest speed that a corner of a box may have, m/s: |v| + |omega| times half the diagonal.
double fastest_corner(const Body& body, const Twist& velocity);
double fastest_corner(const Body& body, const BodyState& state);
/// Whether no corner is faster than `speed`, m/s.
bool is_slower_than(const System& system, const State& state, double speed);

/// Kinetic energy of a cube, and of all, J.
double kinetic_energy(const Body& body, const BodyState& state);
double kinetic_energy(const System& system, const State& state);

/// Kinetic and potential energy, J; zero height is the origin.
double energy(const System& system, const State& state);

}  // namespace wuerfel
