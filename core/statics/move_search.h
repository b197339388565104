/// How far a group of cubes can be moved until a scene falls, or stands: found by looking at moved scenes.
#pragma once

#include "core/statics/carried.h"

namespace wuerfel {

/// Looks at moved scenes, and finds where they change.
class MoveSearch {
 public:
  /// Ends are bracketed to this share of the smaller side.
  static constexpr double bracketed = 1e-9;

  MoveSearch(const StillScene& still, const MotionSettings& settings, const CarriedGroup& group);

  [[nodiscard]] MovedScene at(double s) const { return move(still_, settings_, group_, s); }
  [[nodiscard]] bool stands(double s) const { return at(s).verdict == Verdict::stands; }
  [[nodiscard]] double side() const { return side_; }

  /// Whether the scene stands up to a place, as looks in between tell, and not beyond. On the edge itself
  /// rounding decides, and just behind it high parts move too slowly to be seen.
  [[nodiscard]] bool changes_at(double s, double sense) const;

  /// The last place where a scene stands, and how exactly it is known.
  struct End {
    double s = 0.0;
    double error = 0.0;
  };

  /// Between a place where the scene stands and one where it does not.
  [[nodiscard]] End end(double in, double out) const;

  /// The same by looks alone.
  [[nodiscard]] double edge(double in, double out) const;

  /// Outwards from a place where the scene stands, to the right (+1) or to the left: the last place
  /// before the first change; infinite where none is found beyond all bodies.
  [[nodiscard]] End first_change(double from, double sense) const;

 private:
  /// Where the motion begins, as two places outside tell; the end of an overlap; or the middle.
  [[nodiscard]] double guess(double in,
                             double out,
                             const MovedScene& there,
                             double before,
                             double unrest_before,
                             int k) const;

  /// The length of the scene along the way, m.
  [[nodiscard]] double extent() const;

  const StillScene& still_;
  const MotionSettings& settings_;
  const CarriedGroup& group_;
  double side_;  ///< m, smallest
};

}  // namespace wuerfel
