/// The sweep file: a scene template, what varies in it, and what is wanted of every case. TOML, or
/// JSON with the same keys; read as scenes are, with the same messages.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/argument.h"
#include "app/cli/scene_source.h"
#include "app/sweep/columns.h"
#include "app/sweep/distribution.h"
#include "core/check.h"
#include "render/picture/layers.h"
#include "render/picture/style.h"

namespace wuerfel {

enum class Sampling {
  random,  ///< every case by itself
  latin,   ///< Latin hypercube: each variable's range in as many strata as cases, each met once
  grid,    ///< all combinations of lists
};

/// A key, or several that take the same value, and its distribution.
struct Variable {
  std::string key;                ///< as in --set, or with * where all take the same value
  std::vector<std::string> keys;  ///< those that are set
  Distribution distribution;
  std::string origin;  ///< where it was written, as messages name it
};

/// Cases that are drawn again.
struct Rejection {
  bool overlapping = true;  ///< else an error
  std::vector<Verdict> verdicts;
  std::optional<double> margin_below;  ///< either way
};

/// How many cases of a verdict there shall be.
struct Quota {
  Verdict verdict = Verdict::stands;
  long cases = 0;
  std::string origin{};  ///< "towers.toml: balance.stands", for messages
};

struct HeldOut {
  std::string key;
  std::vector<std::string> values;
};

/// Shares of the splits, in this order, and what belongs to none of them.
struct Split {
  std::vector<std::pair<std::string, double>> shares;
  std::vector<HeldOut> held_out;  ///< goes to "test_ood"
};

/// What is measured.
struct Labels {
  std::vector<CheckColumn> check{CheckColumn::verdict};
  std::vector<RunColumn> run;   ///< empty: no run for labels
  std::optional<double> until;  ///< s; none: the scene's duration
};

/// What is drawn and written besides labels.
struct SampleFiles {
  bool first_frame = false;
  bool instance_mask = false;
  bool violation_mask = false;
  std::optional<double> video;   ///< frames per second
  std::optional<double> states;  ///< rows per second
  PixelSize size{256, 256};
  Layers layers{Layer::cubes};
  Theme theme = Theme::light;
  std::optional<std::vector<double>> view;  ///< x, y, width in m; none: fits the first frame
  double shard_mb = 256.0;

  [[nodiscard]] bool pictures() const {
    return first_frame || instance_mask || violation_mask || video;
  }
};

struct Sweep {
  std::string name;
  std::string description;
  std::string license;
  std::uint64_t seed = 1;
  long cases = 0;
  Sampling sampling = Sampling::random;
  SceneText scene;            ///< the template
  bool scene_inline = false;  ///< it stands in the sweep file
  std::vector<Variable> variables;
  Rejection reject;
  std::vector<Quota> balance;
  Split split;
  Labels labels;
  SampleFiles files;
};

/// A scene named by a path is looked for beside the sweep file unless it is given; `cases` is put in
/// the place of what the file says. Throws SceneError.
Sweep parse_sweep(const SceneText& sweep,
                  const std::optional<SceneText>& scene = {},
                  std::optional<long> cases = {});

/// The keys that are set and their values, as --set has them; one value per variable.
std::vector<std::string> overrides_of(const Sweep& sweep, const std::vector<std::string>& values);

std::string_view to_string(Sampling sampling);

}  // namespace wuerfel
