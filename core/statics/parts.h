/// Parts of a pile: a cube and all it carries, glued into one, on the rest as if that were ground.
/// Inner forces cancel in the resultant, so that each part that falls proves that the scene does.
#pragma once

#include <optional>
#include <vector>

#include "core/statics/generators.h"
#include "core/statics/load_factor.h"
#include "core/statics/loads.h"

namespace wuerfel {

/// For each cube of an island, by its place in it: the cubes that it and what it carries consist of,
/// ascending. A body carries another where a contact between them has an upward normal.
std::vector<std::vector<int>> carried_parts(const StillScene& still, const Island& island);

/// A part that stands on the rest, or does not.
struct PartStand {
  std::vector<int> cubes;  ///< ascending
  double mass = 0.0;       ///< kg
  Vec2 centre = Vec2::Zero();
  LoadRange shift;           ///< m, of its centre to the right, so that it stands; may be empty
  Twist motion;              ///< m/s^2, rad/s^2, of the whole as it would fall; zero: it stands
  std::vector<int> held_by;  ///< contacts of the island with the rest
  bool on_rods = false;      ///< rods join it to the rest
  std::vector<int> presses;  ///< those of them that carry force when it falls
  std::optional<int> pivot;  ///< the contact it tips about; none: it slides or falls freely
  [[nodiscard]] bool stands() const { return motion.linear.isZero(0.0) && motion.angular == 0.0; }
};

/// Of which parts it is asked how far they may be shifted.
enum class Shift { of_what_falls, of_all };

class PartJudge {
 public:
  PartJudge(const StillScene& still, const Island& island);

  [[nodiscard]] PartStand judge(const std::vector<int>& cubes, Shift shift) const;

 private:
  [[nodiscard]] bool is_inner(const PartStand& part, int row) const;
  void glue_rows(PartStand& part, Generators& glued) const;
  void fall(const Generators& glued, PartStand& part) const;
  [[nodiscard]] std::optional<LoadRange> between_supports(const Generators& glued) const;
  [[nodiscard]] Load weight_of(const PartStand& part) const;

  const StillScene* still_;
  const Island* island_;
  Generators generators_;
};

}  // namespace wuerfel
