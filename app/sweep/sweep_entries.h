/// The tables of a sweep file as plain structs, and `describe`, which lists their keys
/// (core/scene/entries.h says how).
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/sweep_file.h"
#include "core/scene/entries.h"
#include "core/scene/spot.h"

namespace wuerfel {

/// [low, high] with low <= high, or [mean, deviation].
struct NumberInterval {
  NumberPair ends;
};
struct WholeInterval {
  std::int64_t low = 0;
  std::int64_t high = 0;
};
/// An array of values as they are written in TOML and JSON.
struct ValueList {
  std::vector<std::string> texts;
};
/// A list of words of which each is one of an enumeration.
template <class Enum>
struct WordList {
  std::vector<Enum> words;
};
/// true, false or { fps = 30 }.
struct RateChoice {
  std::optional<double> fps;
};
/// A path, or the scene itself.
struct TemplateChoice {
  std::string path;
  const Value* table = nullptr;
};

void read(const Spot& spot, const Limits& limits, NumberInterval& target);
void read(const Spot& spot, const Limits& limits, WholeInterval& target);
void read(const Spot& spot, const Limits& limits, ValueList& target);
void read(const Spot& spot, const Limits& limits, RateChoice& target);
void read(const Spot& spot, const Limits& limits, TemplateChoice& target);
void read(const Spot& spot, const Limits& limits, PixelSize& target);
void read(const Spot& spot, const Limits& limits, std::vector<double>& target);
void read(const Spot& spot, const Limits& limits, Layers& target);
void read(const Spot& spot, const Limits& limits, Theme& target);
void read(const Spot& spot, const Limits& limits, Sampling& target);
/// The texts of an array, each once.
std::vector<std::string> words_of(const Spot& spot);
/// Throws SceneError with a suggestion.
[[noreturn]] void refuse_word(const Spot& spot,
                              const std::string& word,
                              const std::vector<std::string_view>& known);

template <class Enum>
void read(const Spot& spot, const Limits& /*limits*/, WordList<Enum>& target) {
  std::vector<std::string_view> known;
  for (int i = 0; to_string(static_cast<Enum>(i)) != "?"; ++i)
    known.push_back(to_string(static_cast<Enum>(i)));
  target.words.clear();
  for (const std::string& word : words_of(spot)) {
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) refuse_word(spot, word, known);
    target.words.push_back(static_cast<Enum>(found - known.begin()));
  }
}

/// The pictures that exist besides the first frame.
enum class Mask { instance, violation };
std::string_view to_string(Mask mask);

struct VaryEntry {
  Origin origin;
  std::string key;
  std::optional<NumberInterval> uniform;
  std::optional<NumberInterval> normal;
  std::optional<NumberInterval> clip;
  std::optional<NumberInterval> log_uniform;
  std::optional<WholeInterval> integers;
  std::optional<ValueList> choice;
  std::optional<ValueList> values;
  std::optional<bool> same_for_all;
};

struct RejectEntry {
  bool overlapping = true;
  std::optional<double> margin_below;
  WordList<Verdict> verdicts;
};

struct BalanceEntry {
  std::optional<std::int64_t> stands;
  std::optional<std::int64_t> falls;
  std::optional<std::int64_t> moves;
};

struct HeldOutEntry {
  Origin origin;
  std::string key;
  ValueList values;
};

struct SplitEntry {
  std::optional<double> train;  ///< none: what the others leave
  double validation = 0.0;
  double test = 0.0;
  std::vector<HeldOutEntry> held_out;
};

struct RunLabelsEntry {
  std::optional<double> until;
  WordList<RunColumn> columns;
};

struct LabelsEntry {
  WordList<CheckColumn> check{{CheckColumn::verdict}};
  RunLabelsEntry run;
};

struct OutputEntry {
  bool first_frame = false;
  WordList<Mask> masks;
  RateChoice video;
  RateChoice states;
  PixelSize size{256, 256};
  Layers layers{Layer::cubes};
  Theme theme = Theme::light;
  std::optional<std::vector<double>> view;
  double shard_mb = 256.0;
};

struct SweepEntries {
  std::int64_t version = 1;
  std::string name;
  std::string description;
  std::string license;
  std::int64_t seed = 1;
  std::optional<std::int64_t> cases;
  Sampling sampling = Sampling::random;
  TemplateChoice scene;
  std::vector<VaryEntry> vary;
  RejectEntry reject;
  BalanceEntry balance;
  SplitEntry split;
  LabelsEntry labels;
  OutputEntry output;
};

namespace limits {
inline constexpr Limits cases{1.0, 1e8};
inline constexpr Limits share{0.0, 1.0};
inline constexpr Limits any{-1e300, 1e300};
inline constexpr Limits frame_rate{1e-3, 1e5};
inline constexpr Limits pixels{16.0, 4096.0};
inline constexpr Limits megabytes{1e-3, 1e5};
inline constexpr Limits prose{0.0, 2000.0};
}  // namespace limits

template <class Keys>
void describe(Keys& keys, VaryEntry& vary) {
  keys.required("key", vary.key, limits::title,
                "What varies, as in --set: cube.a.angle; * is every element: cube.*.mass");
  keys.value("uniform", vary.uniform, limits::any, "[low, high]");
  keys.value("normal", vary.normal, limits::any, "[mean, standard deviation]");
  keys.value("clip", vary.clip, limits::any,
             "[low, high], with normal: draws beyond become the end");
  keys.value("log_uniform", vary.log_uniform, limits::any, "[low, high], both greater than 0");
  keys.value("integers", vary.integers, limits::any, "[low, high], both included");
  keys.value("choice", vary.choice, limits::any, "A list of values, all equally likely");
  keys.value("values", vary.values, limits::any, "A list of values; of a grid each in turn");
  keys.value("same_for_all", vary.same_for_all, "With *: one value for all elements");
  keys.exactly_one({"uniform", "normal", "log_uniform", "integers", "choice", "values"});
  keys.needs("clip", "normal");
}

template <class Keys>
void describe(Keys& keys, RejectEntry& reject) {
  keys.value("overlapping", reject.overlapping, "Draw cases in which bodies overlap again");
  keys.value("margin_below", reject.margin_below, limits::share,
             "Draw knife edges again: a margin, either way, below this share of a cube's side");
  keys.value("verdicts", reject.verdicts, "Draw cases with these verdicts again");
}

template <class Keys>
void describe(Keys& keys, BalanceEntry& balance) {
  keys.value("stands", balance.stands, limits::cases, "Cases that stand");
  keys.value("falls", balance.falls, limits::cases, "Cases that fall");
  keys.value("moves", balance.moves, limits::cases, "Cases that move at the start");
  keys.at_least_one({"stands", "falls", "moves"});
}

template <class Keys>
void describe(Keys& keys, HeldOutEntry& held_out) {
  keys.required("key", held_out.key, limits::title, "A key that varies");
  keys.required("values", held_out.values, limits::any, "The values that go to test_ood");
}

template <class Keys>
void describe(Keys& keys, SplitEntry& split) {
  keys.value("train", split.train, limits::share, "Share of the cases; default: what is left");
  keys.value("validation", split.validation, limits::share, "Share of the cases");
  keys.value("test", split.test, limits::share, "Share of the cases");
  keys.tables("held_out", split.held_out, "Families that are kept for the split test_ood");
}

template <class Keys>
void describe(Keys& keys, RunLabelsEntry& run) {
  keys.value("until", run.until, limits::duration,
             "s, end of the run; default the scene's duration");
  keys.required("columns", run.columns, limits::any, "What is measured of the run");
}

template <class Keys>
void describe(Keys& keys, LabelsEntry& labels) {
  keys.value("check", labels.check, limits::any, "What is told without simulating");
  keys.table("run", labels.run, "Labels of a run");
}

template <class Keys>
void describe(Keys& keys, OutputEntry& output) {
  keys.value("first_frame", output.first_frame, "A picture of the start");
  keys.value("masks", output.masks, limits::any,
             "instance: which cube each pixel shows; violation: what falls by itself and on what");
  keys.value("video", output.video, limits::frame_rate, "A film, or { fps = .. }");
  keys.value("states", output.states, limits::frame_rate, "A table of states, or { fps = .. }");
  keys.value("size", output.size, limits::pixels, "[width, height] of the pictures");
  keys.value("layers", output.layers, limits::any, "What pictures show, as --layers");
  keys.value("theme", output.theme, limits::any, "How, as --theme");
  keys.value("view", output.view, limits::coordinate,
             "[x, y, width] in m; default: fits the first frame");
  keys.value("shard_mb", output.shard_mb, limits::megabytes, "Size of the archives of a data set");
}

template <class Keys>
void describe(Keys& keys, SweepEntries& sweep) {
  keys.value("version", sweep.version, Limits{1.0, 1.0}, "Version of the format");
  keys.required("name", sweep.name, limits::name, "Of the data set");
  keys.value("description", sweep.description, limits::prose, "For the data set card");
  keys.value("license", sweep.license, limits::title, "For the data set card");
  keys.value("seed", sweep.seed, limits::seed, "Another seed gives other cases");
  keys.value("cases", sweep.cases, limits::cases, "How many");
  keys.value("sampling", sweep.sampling, limits::any, "random, latin or grid");
  keys.required("scene", sweep.scene, limits::any, "The template: a scene file, or a table");
  keys.tables("vary", sweep.vary, "What varies");
  keys.table("reject", sweep.reject, "Cases that are drawn again");
  keys.table("balance", sweep.balance, "Cases of each verdict, instead of cases");
  keys.table("split", sweep.split, "Shares of train, validation and test");
  keys.table("labels", sweep.labels, "Columns");
  keys.table("output", sweep.output, "Files of each sample");
}

}  // namespace wuerfel
