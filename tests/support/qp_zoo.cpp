#include "tests/support/qp_zoo.h"

#include <array>
#include <cmath>

namespace wuerfel::test {
namespace {

constexpr double g = 9.81;
constexpr int ground = -1;

/// Collects bodies and contacts and writes them as a program.
class Builder {
 public:
  explicit Builder(const ZooOptions& options)
      : options_(options),
        dice_(options.seed),
        departure_(options.seed + 7919 * (options.step + 1)) {
    program_.clear(3);
  }

  int add_body(double x, double y, double width, double height) {
    const double mass = next_mass() * width * height;
    const double inertia = mass * (width * width + height * height) / 12.0;
    const std::array<double, 3> masses{mass, mass, inertia};
    std::array<double, 3> target{0.0, -g, 0.0};
    if (options_.velocity)
      target = {dice_.uniform(-1.0, 1.0), dice_.uniform(-1.0, 1.0), dice_.uniform(-2.0, 2.0)};
    centre_.push_back({x, y});
    return program_.add_block(masses, target);
  }

  /// A contact at (x, y) that pushes body `on` along the direction (nx, ny) away from body `from`.
  void add_contact(int on, int from, double x, double y, double nx, double ny) {
    x += departure_.uniform(-options_.shift, options_.shift);
    y += departure_.uniform(-options_.shift, options_.shift);
    // A small turn needs no sine: the normal is made a unit vector again.
    const double turn = departure_.uniform(-options_.turn, options_.turn);
    const double length = std::sqrt((1.0 + turn * turn) * (nx * nx + ny * ny));
    const double mx = (nx - turn * ny) / length;
    const double my = (ny + turn * nx) / length;
    for (int copy = 0; copy < options_.copies; ++copy) {
      const double scale = copy == 0 ? 1.0 : dice_.uniform(0.5, 2.0);
      program_.add_inequality(0.0);
      add_entry(on, x, y, scale * mx, scale * my);
      if (from != ground) add_entry(from, x, y, -scale * mx, -scale * my);
    }
  }

  Dice& dice() { return dice_; }
  QuadraticProgram take() { return std::move(program_); }

 private:
  void add_entry(int body, double x, double y, double nx, double ny) {
    const double rx = x - centre_[static_cast<std::size_t>(body)][0];
    const double ry = y - centre_[static_cast<std::size_t>(body)][1];
    const std::array<double, 3> entry{nx, ny, rx * ny - ry * nx};
    program_.add_entry(body, entry);
  }

  double next_mass() {
    switch (options_.masses) {
      case Masses::equal:
        return 1.0;
      case Masses::random_to_1e6: {
        const double root = dice_.uniform(1.0, 10.0);  // root^6 in [1, 1e6]
        return root * root * root * root * root * root;
      }
      case Masses::alternating_1e6:
        return centre_.size() % 2 == 0 ? 1.0 : 1e6;
    }
    return 1.0;
  }

  ZooOptions options_;
  Dice dice_, departure_;
  QuadraticProgram program_;
  std::vector<std::array<double, 2>> centre_;
};

struct Brick {
  int body;
  double left, right;
};

/// The two ends of the overlap of two bricks, if there is one.
void add_bed(Builder& builder, const Brick& on, const Brick& from, double y) {
  const double left = std::max(on.left, from.left);
  const double right = std::min(on.right, from.right);
  if (right - left < 1e-6) return;
  builder.add_contact(on.body, from.body, left, y, 0.0, 1.0);
  builder.add_contact(on.body, from.body, right, y, 0.0, 1.0);
}

}  // namespace

std::uint64_t Dice::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

double Dice::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(next() >> 11U) * 0x1p-53);
}

int Dice::below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }

QuadraticProgram tower(int count, const ZooOptions& options) {
  Builder builder(options);
  Brick below{ground, -1e9, 1e9};
  for (int i = 0; i < count; ++i) {
    const double x = builder.dice().uniform(-0.05, 0.05);
    const Brick brick{builder.add_body(x, i + 0.5, 1.0, 1.0), x - 0.5, x + 0.5};
    add_bed(builder, brick, below, i);
    below = brick;
  }
  return builder.take();
}

QuadraticProgram wall(int layers, int columns, const ZooOptions& options) {
  Builder builder(options);
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
  return builder.take();
}

QuadraticProgram pyramid(int layers, const ZooOptions& options) {
  Builder builder(options);
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
  return builder.take();
}

QuadraticProgram pile(int count, const ZooOptions& options) {
  Builder builder(options);
  const int columns = std::max(3, static_cast<int>(std::sqrt(2.0 * count)));
  std::vector<std::array<double, 2>> centre;
  Dice& dice = builder.dice();
  const auto touch = [&](int on, int from) {
    const auto& a = centre[static_cast<std::size_t>(on)];
    const auto& b = centre[static_cast<std::size_t>(from)];
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
  return builder.take();
}

ZooProgram random_program(int index) {
  Dice dice(static_cast<std::uint64_t>(index) + 1000);
  ZooOptions options;
  options.seed = static_cast<std::uint64_t>(index) + 1;
  const bool perturbed = dice.below(2) == 0;
  if (perturbed) {
    options.shift = 1e-3;
    options.turn = dice.below(2) == 0 ? 3e-4 : 0.05;
  }
  options.velocity = dice.below(4) == 0;
  const int masses = dice.below(6);
  options.masses = masses == 0   ? Masses::random_to_1e6
                   : masses == 1 ? Masses::alternating_1e6
                                 : Masses::equal;
  options.copies = dice.below(8) == 0 ? 2 : 1;
  const int size = 1 + dice.below(6);
  const std::string suffix = std::string(perturbed ? "_perturbed" : "")
                             + (options.velocity ? "_velocity" : "") + (masses < 2 ? "_masses" : "")
                             + (options.copies > 1 ? "_copies" : "");
  switch (dice.below(4)) {
    case 0:
      return {"tower" + suffix, tower(size * size, options)};
    case 1:
      return {"wall" + suffix, wall(size, 1 + dice.below(7), options)};
    case 2:
      return {"pyramid" + suffix, pyramid(size + dice.below(4), options)};
    default:
      return {"pile" + suffix, pile(size * 10, options)};
  }
}

}  // namespace wuerfel::test
