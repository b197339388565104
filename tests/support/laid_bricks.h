/// Towers, walls, pyramids and piles of bricks, laid by whatever builds programs of them: a `Builder` has
/// add_body(x, y, width, height), add_contact(on, from, x, y, nx, ny) and dice().
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/support/qp_zoo.h"

namespace wuerfel::test {

constexpr int ground = -1;

struct Brick {
  int body;
  double left, right;
};

/// The two ends of the overlap of two bricks, if there is one.
template <class Builder>
void add_bed(Builder& builder, const Brick& on, const Brick& from, double y) {
  const double left = std::max(on.left, from.left);
  const double right = std::min(on.right, from.right);
  if (right - left < 1e-6) return;
  builder.add_contact(on.body, from.body, left, y, 0.0, 1.0);
  builder.add_contact(on.body, from.body, right, y, 0.0, 1.0);
}

template <class Builder>
void add_beds(Builder& builder,
              const std::vector<Brick>& bricks,
              const std::vector<Brick>& below,
              double y) {
  for (const Brick& on : bricks) {
    for (const Brick& from : below)
      add_bed(builder, on, from, y);
  }
}

template <class Builder>
void lay_tower(Builder& builder, int count) {
  Brick below{ground, -1e9, 1e9};
  for (int i = 0; i < count; ++i) {
    const double x = builder.dice().uniform(-0.05, 0.05);
    const Brick brick{builder.add_body(x, i + 0.5, 1.0, 1.0), x - 0.5, x + 0.5};
    add_bed(builder, brick, below, i);
    below = brick;
  }
}

/// Between the bricks of a layer.
template <class Builder>
void add_joints(Builder& builder, const std::vector<Brick>& bricks, int layer) {
  for (std::size_t k = 0; k + 1 < bricks.size(); ++k) {
    for (const double y : {layer + 0.0, layer + 1.0})
      builder.add_contact(bricks[k + 1].body, bricks[k].body, bricks[k].right, y, 1.0, 0.0);
  }
}

template <class Builder>
void lay_wall(Builder& builder, int layers, int columns) {
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
    add_beds(builder, bricks, below, layer);
    add_joints(builder, bricks, layer);
    below = bricks;
  }
}

template <class Builder>
void lay_pyramid(Builder& builder, int layers) {
  std::vector<Brick> below{{ground, -1e9, 1e9}};
  for (int layer = 0; layer < layers; ++layer) {
    std::vector<Brick> bricks;
    for (int k = 0; k < layers - layer; ++k) {
      const double x = 1.1 * k + 0.55 * layer;
      bricks.push_back({builder.add_body(x, layer + 0.5, 1.0, 1.0), x - 0.5, x + 0.5});
    }
    add_beds(builder, bricks, below, layer);
    below = bricks;
  }
}

/// A jittered lattice of tilted bodies.
template <class Builder>
void lay_pile(Builder& builder, int count) {
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
}

/// A contact where a program departs from its ideal geometry: its place and its unit normal.
struct Departed {
  double x, y, nx, ny;
};
inline Departed depart(
    double x, double y, double nx, double ny, const ZooOptions& options, Dice& dice) {
  x += dice.uniform(-options.shift, options.shift);
  y += dice.uniform(-options.shift, options.shift);
  // A small turn needs no sine: the normal is made a unit vector again.
  const double turn = dice.uniform(-options.turn, options.turn);
  const double length = std::sqrt((1.0 + turn * turn) * (nx * nx + ny * ny));
  return {x, y, (nx - turn * ny) / length, (ny + turn * nx) / length};
}

/// Mass per area of body `number`.
inline double mass_of(int number, Masses masses, Dice& dice) {
  switch (masses) {
    case Masses::equal:
      return 1.0;
    case Masses::random_to_1e6: {
      const double root = dice.uniform(1.0, 10.0);  // root^6 in [1, 1e6]
      return root * root * root * root * root * root;
    }
    case Masses::alternating_1e6:
      return number % 2 == 0 ? 1.0 : 1e6;
  }
  return 1.0;
}

}  // namespace wuerfel::test
