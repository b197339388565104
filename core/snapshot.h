/// Snapshot: everything a picture may know of the physics. Plain values, no behaviour; the only
/// header of core that the renderer includes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/vec2.h"

namespace wuerfel {

enum class ForceKind { contact, friction, rod_tension, rod_compression };

/// A posed rectangle: a cube, or a fixed box.
struct SnapshotBox {
  std::string name;
  Vec2 center = Vec2::Zero();  ///< m
  double angle = 0.0;          ///< rad, counter-clockwise
  Vec2 size = Vec2::Ones();    ///< m
  bool fixed = false;          ///< drawn as ground, without rods
  int color_index = 0;         ///< running number of the cube: position in the theme's palette
  std::optional<std::array<std::uint8_t, 3>> color;  ///< RGB that the scene asks for
  Vec2 velocity = Vec2::Zero();                      ///< m/s, of the centre
  double spin = 0.0;                                 ///< rad/s
  double mass = 0.0;                                 ///< kg; 0 of fixed boxes
  Vec2 acceleration = Vec2::Zero();                  ///< m/s^2, filled only when asked for
  double angular_acceleration = 0.0;                 ///< rad/s^2, likewise
};

/// A fixed half-plane.
struct SnapshotPlane {
  std::string name;
  Vec2 point = Vec2::Zero();
  Vec2 normal = Vec2::UnitY();  ///< unit vector out of the solid
};

/// What a force can be, over all forces that give the bodies the accelerations they have.
struct SnapshotRange {
  double least = 0.0;  ///< N
  double most = 0.0;   ///< N; infinite where there is no limit
  bool operator==(const SnapshotRange&) const = default;
};

/// A force arrow: starts at `point`, shows `force`.
struct SnapshotForce {
  Vec2 point = Vec2::Zero();  ///< m
  Vec2 force = Vec2::Zero();  ///< N, acts on the body that it points into
  ForceKind kind = ForceKind::contact;
  /// Index into Snapshot::boxes of the body that is pushed, -1 if unknown: arrows move a little
  /// towards it, so that forces on neighbours at one point don't hide each other.
  int body = -1;
  bool unique = true;  ///< no other force is possible there; known where it is asked for
  std::optional<SnapshotRange> range{};  ///< of the force across the side; as with `unique`
  int other = -1;                        ///< of the body that pushes, as of joints; -1 if unknown
  bool operator==(const SnapshotForce&) const = default;
};

/// What one body does to another through the face by which they touch: the resultant of all forces
/// between the two, friction included. Of each pair of forces the one on the body that is carried.
struct SnapshotJoint {
  int body = -1;                ///< index into Snapshot::boxes of the body that `force` acts on
  int other = -1;               ///< of the body that pushes; boxes.size() + k is the plane k
  Vec2 from = Vec2::Zero();     ///< m, ends of the touching part of the face; equal for a corner
  Vec2 to = Vec2::Zero();       ///< m, in the direction of perp(normal) from `from`
  Vec2 point = Vec2::Zero();    ///< m, where the resultant acts, between the two
  Vec2 normal = Vec2::UnitY();  ///< unit vector into `body`
  Vec2 force = Vec2::Zero();    ///< N
  bool unique = true;           ///< no other resultant is possible; known where it is asked for
  std::optional<SnapshotRange> range{};  ///< of its part along the normal; as with `unique`
  bool operator==(const SnapshotJoint&) const = default;
};

/// An impact that happened a moment ago.
struct SnapshotImpact {
  Vec2 point = Vec2::Zero();  ///< m
  double impulse = 0.0;       ///< N s
  double age = 0.0;           ///< 0: just now, 1: forgotten
  bool operator==(const SnapshotImpact&) const = default;
};

/// A rod (Stange) of a cube with its tension.
struct SnapshotRod {
  Vec2 a = Vec2::Zero();  ///< m
  Vec2 b = Vec2::Zero();  ///< m
  double tension = 0.0;   ///< N, tension positive; 0 where forces were not asked for
  bool operator==(const SnapshotRod&) const = default;
};

/// A point mass of the paper's model (Figure 7).
struct SnapshotPoint {
  Vec2 position = Vec2::Zero();  ///< m
  double mass = 0.0;             ///< kg
  bool operator==(const SnapshotPoint&) const = default;
};

/// A free point mass, a body of the scene.
struct SnapshotMass {
  std::string name;
  Vec2 position = Vec2::Zero();  ///< m
  double mass = 0.0;             ///< kg
  Vec2 velocity = Vec2::Zero();  ///< m/s
  bool operator==(const SnapshotMass&) const = default;
};

/// A rod between bodies, or a pin, whose places coincide.
struct SnapshotLink {
  std::string name;
  bool pin = false;
  Vec2 a = Vec2::Zero();  ///< m, place of `from`
  Vec2 b = Vec2::Zero();  ///< m, place of `to`
  /// Names of the bodies that move there; empty: the place is fixed.
  std::array<std::string, 2> bodies;
  Vec2 force = Vec2::Zero();  ///< N, on the body of `from`; zero where forces were not asked for
  double tension = 0.0;       ///< N, of rods, tension positive; likewise
  bool operator==(const SnapshotLink&) const = default;
};

/// A touching point: corner p_k on the side (p_i, p_j), with the unit normal into the corner's
/// body.
struct SnapshotContact {
  Vec2 p_i = Vec2::Zero();
  Vec2 p_j = Vec2::Zero();
  Vec2 p_k = Vec2::Zero();
  Vec2 normal = Vec2::UnitY();
  Vec2 v_i = Vec2::Zero();  ///< m/s, of the three points
  Vec2 v_j = Vec2::Zero();
  Vec2 v_k = Vec2::Zero();
  int on = -1;    ///< index into Snapshot::boxes of the corner's body
  int from = -1;  ///< of the side's; boxes.size() + k is the plane k
  bool operator==(const SnapshotContact&) const = default;
};

/// The triangle of Eq. (2), drawn with its sign: corner p_k before or behind the side (p_i, p_j).
/// Unlike a contact it need not touch.
struct SnapshotSide {
  Vec2 p_i = Vec2::Zero();  ///< m
  Vec2 p_j = Vec2::Zero();  ///< m
  Vec2 p_k = Vec2::Zero();  ///< m
  double area = 0.0;        ///< m^2, A of Eq. (2): twice the signed area, outside is positive
  bool operator==(const SnapshotSide&) const = default;
};

/// What a snapshot should contain beyond bodies; each costs work only where it is asked for.
struct SnapshotRequest {
  bool forces = false;
  bool joints = false;
  bool unique = false;  ///< whether forces and joints are the only possible ones
  bool ranges = false;  ///< and what else they could be, where nothing moves; with `unique`
  bool causes = false;
  bool mechanism = false;
  bool accelerations = false;
  bool rods = false;
  bool rod_forces = false;
  bool points = false;
  bool contacts = false;
  bool sides = false;
  bool operator==(const SnapshotRequest&) const = default;
};

/// Where the centre of a cube has been up to now, oldest first.
struct SnapshotTrail {
  int color_index = 0;
  std::optional<std::array<std::uint8_t, 3>> color;
  std::vector<Vec2> path;  ///< m
};

/// A part that fails by itself: it would fall whatever the rest does if all were held still and let
/// go.
struct SnapshotCause {
  std::vector<int> part{};       ///< indices into Snapshot::boxes
  std::optional<Vec2> centre{};  ///< m, its centre of mass
  std::optional<Vec2> corner{};  ///< m, that it tips over
  Vec2 beside = Vec2::Zero();    ///< m, at the corner's height below the centre; of one that tips
  double outside = 0.0;          ///< m, how far that is beside the support; likewise
  std::string label{};           ///< the same in words; empty: the number
  bool operator==(const SnapshotCause&) const = default;
};

/// How a cube takes part in the motion that proves that nothing holds it.
struct SnapshotMotion {
  int box = -1;             ///< index into Snapshot::boxes
  Vec2 way = Vec2::Zero();  ///< m, of its centre, where the corner that moves most moves by one
  double turn = 0.0;        ///< rad, likewise
  bool operator==(const SnapshotMotion&) const = default;
};

/// Why a scene stands or falls, in words, and what would help.
struct SnapshotReason {
  /// What a change of the scene that makes it stand looks like.
  struct Fix {
    std::vector<int> moved;     ///< indices into Snapshot::boxes
    Vec2 way = Vec2::Zero();    ///< m, of what is moved
    Vec2 point = Vec2::Zero();  ///< m, where a force acts
    Vec2 force = Vec2::Zero();  ///< N
    std::string label;
  };
  std::vector<std::string> headlines;  ///< what fails
  std::vector<std::string> advice;     ///< what would help
  std::vector<Fix> fixes;
};

struct Snapshot {
  double time = 0.0;  ///< s
  std::string title;
  Vec2 gravity = Vec2::Zero();  ///< m/s^2
  double energy = 0.0;          ///< J, kinetic and potential
  double energy_start = 0.0;    ///< J, of the motion
  double force_residual = 0.0;  ///< of the forces; as QpResidual::worst() in core/qp/qp_solver.h
  std::uint64_t revision = 0;   ///< equal revisions: equal pictures but for the time shown
  std::vector<SnapshotBox> boxes;
  std::vector<SnapshotBox> ghosts;  ///< where cubes were before, oldest first; filled by figures
  std::vector<SnapshotPlane> planes;
  std::vector<SnapshotMass> masses;
  std::vector<SnapshotLink> links;
  std::vector<SnapshotForce> forces;
  std::vector<SnapshotJoint> joints;      ///< filled only when asked for
  std::vector<SnapshotImpact> impacts;    ///< filled by films
  std::vector<double> loads;              ///< N, of each box over a moment; filled by films
  std::vector<SnapshotRod> rods;          ///< filled only when asked for
  std::vector<SnapshotPoint> points;      ///< filled only when asked for
  std::vector<SnapshotContact> contacts;  ///< filled only when asked for
  std::vector<SnapshotSide> sides;        ///< filled only when asked for
  std::vector<SnapshotTrail> trails;      ///< filled only when asked for
  std::vector<SnapshotCause> causes;      ///< filled only when asked for
  std::vector<SnapshotMotion> mechanism;  ///< filled only when asked for
  std::optional<SnapshotReason> reason;   ///< filled by figures
};

}  // namespace wuerfel
