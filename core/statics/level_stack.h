/// Piles in which every cube stands on one level face. All forces are vertical then and follow from the
/// weights alone, so that the pile stands if and only if the centre of every cube with what it carries
/// is above the face it stands on: how far a cube can be moved needs no program.
#pragma once

#include <optional>
#include <vector>

#include "core/statics/load_factor.h"
#include "core/statics/still_scene.h"

namespace wuerfel {

class LevelStack {
 public:
  /// None where the island is no such pile. It stands.
  static std::optional<LevelStack> of(const StillScene& still, const Island& island);

  /// m, to the right, of a cube with what it carries; none where it would come near to something else.
  [[nodiscard]] std::optional<LoadRange> move_range(int cube) const;

 private:
  /// Along the right of gravity, m.
  struct Interval {
    double low = unbounded;
    double high = -unbounded;
    void include(double x) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
    [[nodiscard]] bool meets(const Interval& other, double room) const {
      return low - room <= other.high && other.low <= high + room;
    }
  };
  /// A cube with what it carries.
  struct Part {
    int below = -1;  ///< body that the cube stands on
    Interval touch;  ///< where it does
    double mass = 0.0;
    double centre = 0.0;  ///< m, to the right
  };

  explicit LevelStack(const StillScene& still);
  bool add_contact(const Contact& contact);
  void add_weights(const Island& island);
  [[nodiscard]] bool is_on(int cube, int base) const;
  [[nodiscard]] Interval along(int body, const Vec2& axis) const;
  [[nodiscard]] LoadRange on_support(int cube) const;
  [[nodiscard]] bool is_barred(int cube, const LoadRange& asked) const;
  [[nodiscard]] bool is_barred_for(int moved, int base, const LoadRange& range) const;

  const StillScene* still_;
  Vec2 right_;
  std::vector<Box> boxes_;
  std::vector<Part> parts_;  ///< per cube of the scene
};

}  // namespace wuerfel
