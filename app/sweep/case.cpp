#include "app/sweep/case.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/exit_code.h"
#include "app/sweep/digest.h"
#include "core/scene/json_string.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t id_digits = 16;

// 7 and 7.0 are one value.
bool same_value(const std::string& a, const std::string& b) {
  return Json::parse(a) == Json::parse(b);
}

bool is_held_out(const Sweep& sweep, const HeldOut& held_out, const Case& one) {
  const auto variable = std::ranges::find(sweep.variables, held_out.key, &Variable::key);
  const std::string& value = one.values.at(variable - sweep.variables.begin());
  return std::ranges::any_of(held_out.values,
                             [&](const std::string& other) { return same_value(value, other); });
}

// Uniform in [0, 1), by the name.
double position(const std::string& id) {
  std::uint64_t bits = 0;
  std::from_chars(id.data(), id.data() + id.size(), bits, id_digits);
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

}  // namespace

Scene scene_of(const Sweep& sweep, const std::vector<std::string>& values) {
  return parse(sweep.scene, overrides_of(sweep, values));
}

std::string case_id(const Sweep& sweep, const Scene& scene) {
  return Sha256().add(sweep.name).add("\n").add(normalised_scene(scene)).hex().substr(0, id_digits);
}

std::string split_of(const Sweep& sweep, const Case& one) {
  for (const HeldOut& held_out : sweep.split.held_out)
    if (is_held_out(sweep, held_out, one)) return "test_ood";
  double rest = position(one.id);
  for (const auto& [name, share] : sweep.split.shares) {
    if (rest < share) return name;
    rest -= share;
  }
  return sweep.split.shares.front().first;  // by rounding
}

std::string values_json(const Sweep& sweep, const Case& one) {
  std::string values;
  for (std::size_t v = 0; v < one.values.size(); ++v) {
    values += v == 0 ? '{' : ',';
    values += json_string(sweep.variables[v].key) + ':' + one.values[v];
  }
  return values + '}';
}

std::string line_of(const Sweep& sweep, const Case& one) {
  return fmt::format(R"({{"case":{},"id":"{}","split":"{}","values":{}}})", one.number, one.id,
                     one.split, values_json(sweep, one));
}

Case case_of(const Sweep& sweep, std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  try {
    Case one{json.at("case"), json.at("id"), json.at("split"), {}};
    for (const Variable& variable : sweep.variables)
      one.values.push_back(json.at("values").at(variable.key).dump());
    return one;
  } catch (const Json::exception&) {
    throw UsageError(
        fmt::format("the manifest has a line that is no case: {}", line.substr(0, 80)));
  }
}

}  // namespace wuerfel
