/// Seeded programs with friction: towers, walls, pyramids, dominoes and piles of squares, at rest,
/// on an incline, punched or hit. Velocity level, b = 0: standing still is always possible.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/qp/coulomb/friction_program.h"
#include "tests/support/qp_zoo.h"

namespace wuerfel::test {

/// A FrictionProgram that owns its rows.
struct FrictionCase {
  QuadraticProgram program;
  std::vector<FrictionContact> contacts;
  [[nodiscard]] FrictionProgram view() const { return {program, contacts}; }
};

struct FrictionOptions {
  double mu = 0.5;
  double incline = 0.0;  ///< tangent of the angle by which gravity leans to +x
  double punch = 0.0;    ///< speed of one body in the middle, along x, in metres per second
  double spin = 0.0;     ///< of the same body
  bool tumble = false;   ///< random velocities of all bodies up to 1
  ZooOptions zoo{};
};

/// Bodies and contacts, written as a velocity program over a step of 1/240 s under gravity.
class FrictionBuilder {
 public:
  explicit FrictionBuilder(const FrictionOptions& options);
  int add_body(double x, double y, double width, double height);
  /// At (x, y), pushing `on` along (nx, ny) away from `from`; the tangent is the normal turned left.
  void add_contact(int on, int from, double x, double y, double nx, double ny);
  void set_velocity(int body, double vx, double vy, double spin);
  [[nodiscard]] int bodies() const { return static_cast<int>(centre_.size()); }
  Dice& dice() { return dice_; }
  FrictionCase take();

 private:
  void add_row(int on, int from, double x, double y, double nx, double ny);

  FrictionOptions options_;
  Dice dice_, departure_;
  FrictionCase case_;
  std::vector<std::pair<double, double>> centre_;
};

FrictionCase friction_tower(int count, const FrictionOptions& options);
FrictionCase friction_wall(int layers, int columns, const FrictionOptions& options);
FrictionCase friction_pyramid(int layers, const FrictionOptions& options);
/// Dominoes 0.2 x 1, side by side; the punch goes to the first.
FrictionCase friction_dominoes(int count, const FrictionOptions& options);
FrictionCase friction_pile(int count, const FrictionOptions& options);

}  // namespace wuerfel::test
