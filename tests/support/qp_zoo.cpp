#include "tests/support/qp_zoo.h"

#include <array>

#include "tests/support/laid_bricks.h"

namespace wuerfel::test {
namespace {

constexpr double g = 9.81;

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
    const double mass = mass_of(bodies(), options_.masses, dice_) * width * height;
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
    const Departed c = depart(x, y, nx, ny, options_, departure_);
    for (int copy = 0; copy < options_.copies; ++copy) {
      const double scale = copy == 0 ? 1.0 : dice_.uniform(0.5, 2.0);
      program_.add_inequality(0.0);
      add_entry(on, c.x, c.y, scale * c.nx, scale * c.ny);
      if (from != ground) add_entry(from, c.x, c.y, -scale * c.nx, -scale * c.ny);
    }
  }

  Dice& dice() { return dice_; }
  QuadraticProgram take() { return std::move(program_); }

 private:
  void add_entry(int body, double x, double y, double nx, double ny) {
    const double rx = x - centre_[body][0];
    const double ry = y - centre_[body][1];
    const std::array<double, 3> entry{nx, ny, rx * ny - ry * nx};
    program_.add_entry(body, entry);
  }

  [[nodiscard]] int bodies() const { return static_cast<int>(centre_.size()); }

  ZooOptions options_;
  Dice dice_, departure_;
  QuadraticProgram program_;
  std::vector<std::array<double, 2>> centre_;
};

}  // namespace

QuadraticProgram tower(int count, const ZooOptions& options) {
  Builder builder(options);
  lay_tower(builder, count);
  return builder.take();
}

QuadraticProgram wall(int layers, int columns, const ZooOptions& options) {
  Builder builder(options);
  lay_wall(builder, layers, columns);
  return builder.take();
}

QuadraticProgram pyramid(int layers, const ZooOptions& options) {
  Builder builder(options);
  lay_pyramid(builder, layers);
  return builder.take();
}

QuadraticProgram pile(int count, const ZooOptions& options) {
  Builder builder(options);
  lay_pile(builder, count);
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
