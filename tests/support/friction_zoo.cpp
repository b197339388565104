#include "tests/support/friction_zoo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace wuerfel::test {
namespace {

constexpr double g_step = 9.81 / 240.0;
constexpr int ground = FrictionBuilder::ground;

struct Brick {
  int body;
  double left, right;
};

/// The two ends of the overlap of two bricks, if there is one.
void add_bed(FrictionBuilder& builder, const Brick& on, const Brick& from, double y) {
  const double left = std::max(on.left, from.left);
  const double right = std::min(on.right, from.right);
  if (right - left < 1e-6) return;
  builder.add_contact(on.body, from.body, left, y, 0.0, 1.0);
  builder.add_contact(on.body, from.body, right, y, 0.0, 1.0);
}

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
  const double mass = next_mass() * width * height;
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
  x += departure_.uniform(-options_.zoo.shift, options_.zoo.shift);
  y += departure_.uniform(-options_.zoo.shift, options_.zoo.shift);
  // A small turn needs no sine: the normal is made a unit vector again.
  const double turn = departure_.uniform(-options_.zoo.turn, options_.zoo.turn);
  const double length = std::sqrt((1.0 + turn * turn) * (nx * nx + ny * ny));
  const double mx = (nx - turn * ny) / length;
  const double my = (ny + turn * nx) / length;
  const int normal = case_.program.add_inequality(0.0);
  add_row(on, from, x, y, mx, my);
  const int tangent = case_.program.add_equality(0.0);
  add_row(on, from, x, y, -my, mx);
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

double FrictionBuilder::next_mass() {
  switch (options_.zoo.masses) {
    case Masses::equal:
      return 1.0;
    case Masses::random_to_1e6: {
      const double root = dice_.uniform(1.0, 10.0);
      return root * root * root * root * root * root;
    }
    case Masses::alternating_1e6:
      return centre_.size() % 2 == 0 ? 1.0 : 1e6;
  }
  return 1.0;
}

FrictionCase FrictionBuilder::take() { return std::move(case_); }

FrictionCase friction_tower(int count, const FrictionOptions& options) {
  FrictionBuilder builder(options);
  Brick below{ground, -1e9, 1e9};
  for (int i = 0; i < count; ++i) {
    const double x = builder.dice().uniform(-0.05, 0.05);
    const Brick brick{builder.add_body(x, i + 0.5, 1.0, 1.0), x - 0.5, x + 0.5};
    add_bed(builder, brick, below, i);
    below = brick;
  }
  punch(builder, count / 2, options);
  return builder.take();
}

FrictionCase friction_wall(int layers, int columns, const FrictionOptions& options) {
  FrictionBuilder builder(options);
  std::vector<Brick> below{{ground, -1e9, 1e9}};
  for (int layer = 0; layer < layers; ++layer) {
    std::vector<Brick> bricks;
    const auto add = [&](double left, double right) {
      bricks.push_back(
          {builder.add_body(0.5 * (left + right), layer + 0.5, right - left, 1.0), left, right});
    };
    const bool whole = layer % 2 == 0;
    if (!whole) add(0.0, 1.0);
    for (int k = 0; k < (whole ? columns : columns - 1); ++k)
      add(2.0 * k + (whole ? 0.0 : 1.0), 2.0 * k + (whole ? 2.0 : 3.0));
    if (!whole) add(2.0 * columns - 1.0, 2.0 * columns);
    for (const Brick& on : bricks) {
      for (const Brick& from : below)
        add_bed(builder, on, from, layer);
    }
    for (std::size_t k = 0; k + 1 < bricks.size(); ++k) {
      for (const double y : {layer + 0.0, layer + 1.0})
        builder.add_contact(bricks[k + 1].body, bricks[k].body, bricks[k].right, y, 1.0, 0.0);
    }
    below = bricks;
  }
  punch(builder, builder.bodies() / 2, options);
  return builder.take();
}

FrictionCase friction_pyramid(int layers, const FrictionOptions& options) {
  FrictionBuilder builder(options);
  std::vector<Brick> below{{ground, -1e9, 1e9}};
  for (int layer = 0; layer < layers; ++layer) {
    std::vector<Brick> bricks;
    for (int k = 0; k < layers - layer; ++k) {
      const double x = 1.1 * k + 0.55 * layer;
      bricks.push_back({builder.add_body(x, layer + 0.5, 1.0, 1.0), x - 0.5, x + 0.5});
    }
    for (const Brick& on : bricks) {
      for (const Brick& from : below)
        add_bed(builder, on, from, layer);
    }
    below = bricks;
  }
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
  const int columns = std::max(3, static_cast<int>(std::sqrt(2.0 * count)));
  std::vector<std::array<double, 2>> centre;
  Dice& dice = builder.dice();
  const auto touch = [&](int on, int from) {
    const std::array<double, 2>& a = centre[on];
    const std::array<double, 2>& b = centre[from];
    const double tilt = dice.uniform(-0.4, 0.4);
    const double dx = a[0] - b[0];
    const double dy = a[1] - b[1];
    builder.add_contact(on, from, 0.5 * (a[0] + b[0]) + dice.uniform(-0.2, 0.2),
                        0.5 * (a[1] + b[1]), dx - tilt * dy, dy + tilt * dx);
  };
  for (int i = 0; i < count; ++i) {
    const int layer = i / columns;
    const int column = i % columns;
    const double x = column + 0.5 * (layer % 2) + dice.uniform(-0.15, 0.15);
    const double y = 0.5 + 0.9 * layer + dice.uniform(-0.05, 0.05);
    centre.push_back({x, y});
    builder.add_body(x, y, 0.8, 0.8);
    if (layer == 0) {
      builder.add_contact(i, ground, x + dice.uniform(-0.5, -0.1), 0.0, 0.0, 1.0);
      builder.add_contact(i, ground, x + dice.uniform(0.1, 0.5), 0.0, 0.0, 1.0);
    } else {
      touch(i, i - columns);
      const int other = layer % 2 == 0 ? i - columns - 1 : i - columns + 1;
      if (other / columns == layer - 1) touch(i, other);
    }
    if (column > 0 && dice.uniform(0.0, 1.0) < 0.45) touch(i, i - 1);
  }
  punch(builder, count / 2, options);
  return builder.take();
}

}  // namespace wuerfel::test
