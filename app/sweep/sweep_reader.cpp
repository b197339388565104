#include "app/sweep/sweep_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/scene_source.h"
#include "app/sweep/value_json.h"
#include "core/scene/json_reader.h"
#include "core/scene/scene_parser.h"
#include "core/scene/scene_text.h"
#include "core/scene/suggestion.h"
#include "core/scene/toml_reader.h"

namespace wuerfel {

Value read_document(std::string_view text, const SceneSource& source) {
  const SceneLanguage language = language_of(text, source.name);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    source.fail({1, 1}, "", "empty; a sweep needs name, scene and [[vary]]");
  check_text(text, language, source);
  return language == SceneLanguage::json ? read_json(text, source) : read_toml(text, source);
}

namespace {

/// The sweep of the entries of one file.
class SweepReader {
 public:
  SweepReader(const SweepEntries& entries,
              const SceneSource& source,
              const std::optional<SceneText>& scene)
      : entries_(entries), source_(source), given_(scene) {}

  Sweep read() {
    sweep_.name = entries_.name;
    sweep_.description = entries_.description;
    sweep_.license = entries_.license;
    sweep_.seed = static_cast<std::uint64_t>(entries_.seed);
    sweep_.sampling = entries_.sampling;
    sweep_.reject = {entries_.reject.overlapping, entries_.reject.verdicts.words,
                     entries_.reject.margin_below};
    read_scene();
    for (const VaryEntry& vary : entries_.vary)
      read_variable(vary);
    read_balance();
    sweep_.cases = number_of_cases();
    read_split();
    sweep_.labels = {entries_.labels.check.words, entries_.labels.run.columns.words,
                     entries_.labels.run.until};
    read_output();
    return std::move(sweep_);
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    source_.fail({}, path, message);
  }
  [[noreturn]] static void fail(const SceneSource& source,
                                const Origin& origin,
                                std::string_view key,
                                const std::string& message) {
    const Member* member = find_member(std::get<Value::Table>(origin.table->data), key);
    source.fail(member == nullptr ? origin.table->place : member->place,
                fmt::format("{}.{}", origin.path, key), message);
  }

  void read_scene() {
    const TemplateChoice& choice = entries_.scene;
    sweep_.scene_inline = choice.table != nullptr;
    if (sweep_.scene_inline) {
      template_ = *choice.table;
      sweep_.scene = {source_.name + " [scene]", json_of(template_).dump()};
      return;
    }
    sweep_.scene = given_ ? *given_ : scene_at(choice.path);
    template_ = read_document(sweep_.scene.text, {sweep_.scene.name, {}});
  }

  // Beside the sweep file, or of those that come along.
  SceneText scene_at(const std::string& path) const {
    const auto beside = std::filesystem::path(source_.name).parent_path() / path;
    std::error_code ignored;
    if (path == "-") fail("scene", "cannot be standard input");
    try {
      return scene_text(std::filesystem::exists(beside, ignored) ? beside.string() : path);
    } catch (const SceneError& error) {
      fail("scene", error.what());
    }
  }

  void read_variable(const VaryEntry& vary) {
    const Distribution distribution = distribution_of(vary);
    const std::vector<std::string> keys = keys_of(vary);
    const bool together = keys.size() == 1 || vary.same_for_all.value_or(is_grid());
    if (is_grid() && !together) {
      fail(source_, vary.origin, "same_for_all",
           "is true in a grid: each list is gone through once");
    }
    if (is_grid() && all_values(distribution).empty())
      fail(source_, vary.origin, "key", "a grid needs a list here: values, choice or integers");
    if (together) {
      add({vary.key, keys, distribution, origin_of(vary)}, vary);
      return;
    }
    for (const std::string& key : keys)
      add({key, {key}, distribution, origin_of(vary)}, vary);
  }

  [[nodiscard]] std::string origin_of(const VaryEntry& vary) const {
    const int line = vary.origin.table->place.line;
    const std::string file = line > 0 ? fmt::format("{}:{}", source_.name, line) : source_.name;
    return fmt::format("{}: {}", file, vary.origin.path);
  }

  void add(Variable variable, const VaryEntry& vary) {
    const auto same = std::ranges::find(sweep_.variables, variable.key, &Variable::key);
    if (same != sweep_.variables.end())
      fail(source_, vary.origin, "key", fmt::format("{} varies already", variable.key));
    sweep_.variables.push_back(std::move(variable));
  }

  [[nodiscard]] bool is_grid() const { return entries_.sampling == Sampling::grid; }

  Distribution distribution_of(const VaryEntry& vary) const {
    if (vary.uniform) return Uniform{ascending(vary, "uniform", *vary.uniform)};
    if (vary.log_uniform) {
      const NumberPair ends = ascending(vary, "log_uniform", *vary.log_uniform);
      if (ends.first <= 0.0)
        fail(source_, vary.origin, "log_uniform", "both ends must be greater than 0");
      return LogUniform{ends};
    }
    if (vary.normal) return normal_of(vary);
    if (vary.integers) return Integers{vary.integers->low, vary.integers->high};
    return OneOf{vary.choice ? vary.choice->texts : vary.values->texts};
  }

  Normal normal_of(const VaryEntry& vary) const {
    Normal normal{vary.normal->ends, std::nullopt};
    if (normal.mean_and_deviation.second <= 0.0)
      fail(source_, vary.origin, "normal", "the standard deviation must be greater than 0");
    if (vary.clip) normal.clip = ascending(vary, "clip", *vary.clip);
    return normal;
  }

  NumberPair ascending(const VaryEntry& vary,
                       std::string_view key,
                       const NumberInterval& ends) const {
    if (ends.ends.first > ends.ends.second)
      fail(source_, vary.origin, key, "must be [low, high] with low <= high");
    return ends.ends;
  }

  // cube.*.mass: of every [[cube]] of the template.
  std::vector<std::string> keys_of(const VaryEntry& vary) const {
    const std::size_t star = vary.key.find(".*.");
    if (star == std::string::npos) {
      if (vary.same_for_all) fail(source_, vary.origin, "same_for_all", "is of use only with *");
      return {vary.key};
    }
    const std::string kind = vary.key.substr(0, star);
    const auto* table = std::get_if<Value::Table>(&template_.data);
    const Member* member = table == nullptr ? nullptr : find_member(*table, kind);
    const auto* items =
        member == nullptr ? nullptr : std::get_if<Value::Array>(&member->value.data);
    if (items == nullptr)
      fail(source_, vary.origin, "key", fmt::format("the template has no [[{}]]", kind));
    std::vector<std::string> keys;
    for (std::size_t i = 1; i <= items->size(); ++i)
      keys.push_back(fmt::format("{}.{}.{}", kind, i, vary.key.substr(star + 3)));
    return keys;
  }

  void read_balance() {
    const BalanceEntry& balance = entries_.balance;
    for (const auto& [verdict, cases] :
         {std::pair{Verdict::stands, balance.stands}, std::pair{Verdict::falls, balance.falls},
          std::pair{Verdict::moves, balance.moves}}) {
      if (!cases) continue;
      const std::string key = fmt::format("balance.{}", to_string(verdict));
      sweep_.balance.push_back({verdict, *cases, fmt::format("{}: {}", source_.name, key)});
      if (std::ranges::count(sweep_.reject.verdicts, verdict) > 0) fail(key, "is rejected, too");
    }
    if (!sweep_.balance.empty() && entries_.sampling != Sampling::random)
      fail("balance", "needs sampling = \"random\": other designs have as many cases as they have");
  }

  long number_of_cases() const {
    long all = 0;
    for (const Quota& quota : sweep_.balance)
      all += quota.cases;
    if (is_grid()) all = grid_size();
    if (all > 0) {
      if (const auto given = entries_.cases.value_or(all); given != all) {
        fail("cases", fmt::format("is {}, but {} makes {}; leave cases out", given,
                                  is_grid() ? "the grid" : "[balance]", all));
      }
      return all;
    }
    if (!entries_.cases) fail("", "needs cases");
    return *entries_.cases;
  }

  long grid_size() const {
    double size = 1.0;
    for (const Variable& variable : sweep_.variables)
      size *= static_cast<double>(all_values(variable.distribution).size());
    if (size > limits::cases.max) {
      fail("vary", fmt::format("the grid has {:g} cases; at most {:g} are allowed", size,
                               limits::cases.max));
    }
    return static_cast<long>(size);
  }

  void read_split() {
    const SplitEntry& split = entries_.split;
    const double train = split.train.value_or(1.0 - split.validation - split.test);
    const double sum = train + split.validation + split.test;
    constexpr double rounding = 1e-9;
    if (train < 0.0 || std::abs(sum - 1.0) > rounding)
      fail("split", fmt::format("the shares must add up to 1; they are {:g} together", sum));
    sweep_.split.shares = {
        {"train", train}, {"validation", split.validation}, {"test", split.test}};
    for (const HeldOutEntry& entry : split.held_out) {
      const std::vector<Variable>& variables = sweep_.variables;
      if (std::ranges::find(variables, entry.key, &Variable::key) == variables.end()) {
        fail(source_, entry.origin, "key",
             fmt::format("{} does not vary{}", entry.key,
                         suggestion(entry.key, variables, &Variable::key)));
      }
      sweep_.split.held_out.push_back({entry.key, entry.values.texts});
    }
  }

  void read_output() {
    const OutputEntry& output = entries_.output;
    SampleFiles& files = sweep_.files;
    files.first_frame = output.first_frame;
    files.instance_mask = std::ranges::count(output.masks.words, Mask::instance) > 0;
    files.violation_mask = std::ranges::count(output.masks.words, Mask::violation) > 0;
    files.video = output.video.fps;
    files.states = output.states.fps;
    files.size = output.size;
    files.layers = output.layers;
    files.theme = output.theme;
    files.view = output.view;
    files.shard_mb = output.shard_mb;
    if (files.view && (files.view->size() != 3 || (*files.view)[2] <= 0.0))
      fail("output.view", "must be [x, y, width] with a width greater than 0");
    if (files.video && (files.size.width % 2 != 0 || files.size.height % 2 != 0))
      fail("output.size", "must be even where there is a film");
  }

  const SweepEntries& entries_;
  const SceneSource& source_;
  const std::optional<SceneText>& given_;
  Value template_;
  Sweep sweep_;
};

}  // namespace

Sweep read_sweep(const SweepEntries& entries,
                 const SceneSource& source,
                 const std::optional<SceneText>& scene) {
  return SweepReader(entries, source, scene).read();
}

}  // namespace wuerfel
