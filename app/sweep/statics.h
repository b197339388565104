/// What a scene tells at rest: verdict, margin and causes, each found when it is first asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/columns.h"
#include "core/check.h"
#include "core/scene/scene.h"
#include "core/statics/causes.h"
#include "core/statics/margins.h"

namespace wuerfel {

/// How near the verdict is to another one.
struct Nearest {
  double margin = 0.0;  ///< share of the smaller side of the cube; negative where the scene falls
  int cube = 0;         ///< whose weight has to be shifted least
};

class Statics {
 public:
  explicit Statics(const Scene& scene) : scene_(scene) {}

  const Check& check();
  /// Nothing where something moves, or no shift changes the verdict.
  const std::optional<Nearest>& nearest();
  /// The smallest part that falls by itself; nothing where there is none.
  const std::optional<Cause>& cause();
  /// Per cube 1 where it is of the smallest part that falls by itself, 2 where that part presses on
  /// it, else 0.
  std::vector<std::uint16_t> violations();
  LabelRow labels(const std::vector<CheckColumn>& columns);

 private:
  /// None where something moves, or the verdict is undecided: then there is no margin.
  const std::optional<StillScene>& still();
  Label label(CheckColumn column);
  [[nodiscard]] std::string cause_text();

  const Scene& scene_;
  std::optional<Check> check_;
  std::optional<std::optional<StillScene>> still_;
  std::optional<std::optional<Nearest>> nearest_;
  std::optional<std::optional<Cause>> cause_;
};

}  // namespace wuerfel
