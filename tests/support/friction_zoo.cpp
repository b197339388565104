#include "tests/support/friction_zoo.h"

#include <array>
#include <cmath>
#include <utility>

#include "tests/support/laid_bricks.h"

namespace wuerfel::test {
namespace {

constexpr double g_step = 9.81 / 240.0;

void punch(FrictionBuilder& builder, int body, const FrictionOptions& options) {
  if (options.punch != 0.0 || options.spin != 0.0)
    builder.set_velocity(body, options.punch, 0.0, options.spin);
}

}  // namespace

FrictionBuilder::FrictionBuilder(const FrictionOptions& options)
    : options_(options),
      dice_(options.zoo.seed),
      departure_(options.zoo.seed + 7919 * (options.zoo.step + 1)) {
  case_.program.clear(3);
}

int FrictionBuilder::add_body(double x, double y, double width, double height) {
  const double mass = mass_of(bodies(), options_.zoo.masses, dice_) * width * height;
  const double inertia = mass * (width * width + height * height) / 12.0;
  const double length = std::sqrt(1.0 + options_.incline * options_.incline);
  std::array<double, 3> target{g_step * options_.incline / length, -g_step / length, 0.0};
  if (options_.tumble) {
    target[0] += dice_.uniform(-1.0, 1.0);
    target[1] += dice_.uniform(-1.0, 1.0);
    target[2] += dice_.uniform(-2.0, 2.0);
  }
  centre_.emplace_back(x, y);
  return case_.program.add_block(std::array{mass, mass, inertia}, target);
}

void FrictionBuilder::set_velocity(int body, double vx, double vy, double spin) {
  case_.program.target[3 * body] += vx;
  case_.program.target[3 * body + 1] += vy;
  case_.program.target[3 * body + 2] += spin;
}

void FrictionBuilder::add_contact(int on, int from, double x, double y, double nx, double ny) {
  const Departed c = depart(x, y, nx, ny, options_.zoo, departure_);
  const int normal = case_.program.add_inequality(0.0);
  add_row(on, from, c.x, c.y, c.nx, c.ny);
  const int tangent = case_.program.add_equality(0.0);
  add_row(on, from, c.x, c.y, -c.ny, c.nx);
  case_.contacts.push_back({.normal = normal, .tangent = tangent, .mu = options_.mu});
}

void FrictionBuilder::add_row(int on, int from, double x, double y, double nx, double ny) {
  const auto add = [&](int body, double sign) {
    if (body == ground) return;
    const double rx = x - centre_[body].first;
    const double ry = y - centre_[body].second;
    case_.program.add_entry(body, std::array{sign * nx, sign * ny, sign * (rx * ny - ry * nx)});
  };
  add(on, 1.0);
  add(from, -1.0);
}

FrictionCase FrictionBuilder::take() { return std::move(case_); }

FrictionCase friction_tower(int count, const FrictionOptions& options) {
  FrictionBuilder builder(options);
  lay_tower(builder, count);
  punch(builder, count / 2, options);
  return builder.take();
}

FrictionCase friction_wall(int layers, int columns, const FrictionOptions& options) {
  FrictionBuilder builder(options);
  lay_wall(builder, layers, columns);
  punch(builder, builder.bodies() / 2, options);
  return builder.take();
}

FrictionCase friction_pyramid(int layers, const FrictionOptions& options) {
  FrictionBuilder builder(options);
  lay_pyramid(builder, layers);
  punch(builder, builder.bodies() / 2, options);
  return builder.take();
}

FrictionCase friction_dominoes(int count, const FrictionOptions& options) {
  FrictionBuilder builder(options);
  for (int i = 0; i < count; ++i) {
    const Brick brick{builder.add_body(0.2 * i + 0.1, 0.5, 0.2, 1.0), 0.2 * i, 0.2 * i + 0.2};
    add_bed(builder, brick, {ground, -1e9, 1e9}, 0.0);
    if (i == 0) continue;
    builder.add_contact(i, i - 1, brick.left, 0.0, 1.0, 0.0);
    builder.add_contact(i, i - 1, brick.left, 1.0, 1.0, 0.0);
  }
  punch(builder, 0, options);
  return builder.take();
}

FrictionCase friction_pile(int count, const FrictionOptions& options) {
  FrictionBuilder builder(options);
  lay_pile(builder, count);
  punch(builder, count / 2, options);
  return builder.take();
}

}  // namespace wuerfel::test
