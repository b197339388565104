#include "app/sweep/plan.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/exit_code.h"
#include "app/sweep/digest.h"
#include "app/sweep/plan_files.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

// Of a file that belongs to the plan: exactly the bytes that were written.
SceneText read_part(const Plan& plan, const std::string& name, const std::string& hash) {
  SceneText text = scene_text(plan.path(name));
  if (sha256(text.text) != hash) {
    throw UsageError(fmt::format("{}: has been changed since the plan was made; make a new plan",
                                 plan.path(name)));
  }
  return text;
}

Json read_plan_json(const std::string& folder, const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  const std::string name = folder + "/" + plan_name;
  if (!json.is_object() || !json.contains("format") || !json.contains("version"))
    throw UsageError(fmt::format("{}: is no plan of wuerfel sweep", name));
  if (json["format"] != plan_format || json["version"] != WUERFEL_VERSION) {
    throw UsageError(fmt::format(
        "{}: the plan was made by wuerfel {} (format {}), this is {} (format {}): make it anew, or "
        "go on with that program",
        name, json["version"].dump(), json["format"].dump(), WUERFEL_VERSION, plan_format));
  }
  return json;
}

PlanCounts counts_of(const Json& json) {
  PlanCounts counts;
  counts.cases = json.at("cases");
  counts.drawn = json.at("drawn");
  const Json& no = json.at("rejected");
  counts.rejected = {no.at("overlapping"), no.at("verdict"), no.at("margin"), no.at("over_quota"),
                     no.at("duplicate")};
  counts.splits = json.at("splits").get<std::map<std::string, long>>();
  return counts;
}

std::string plan_text(const std::string& folder) {
  const std::string path = folder + "/" + plan_name;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    throw UsageError(
        fmt::format("{}: holds no {}; make a plan with: wuerfel sweep plan SWEEP -o {}", folder,
                    plan_name, folder));
  }
  return scene_text(path).text;
}

}  // namespace

std::string describe(const Rejected& rejected) {
  return fmt::format(
      "{} overlapped, {} had a verdict that is rejected, {} were too near to the edge, {} had a "
      "verdict of which there were enough, {} were there already",
      rejected.overlapping, rejected.verdict, rejected.margin, rejected.over_quota,
      rejected.duplicate);
}

SweepText::SweepText(SceneText sweep_file,
                     const std::optional<SceneText>& scene,
                     std::optional<long> cases_asked)
    : file(std::move(sweep_file)), cases(cases_asked), sweep(parse_sweep(file, scene, cases)) {}

Plan::Plan(std::string folder) : folder_(std::move(folder)) {
  const std::string text = plan_text(folder_);
  const Json json = read_plan_json(folder_, text);
  hash_ = sha256(text);
  try {
    counts_ = counts_of(json);
    sweep_file_ = json.at("files").at("sweep");
    scene_file_ = json.at("files").at("scene");
    const Json& hashes = json.at("sha256");
    std::optional<SceneText> scene;
    if (!scene_file_.empty()) scene = read_part(*this, scene_file_, hashes.at("scene"));
    const Json& asked = json.at("cases_asked");
    text_.emplace(read_part(*this, sweep_file_, hashes.at("sweep")), scene,
                  asked.is_null() ? std::nullopt : std::optional<long>(asked));
    if (sha256_of_file(path(manifest_name)) != hashes.at("manifest")) {
      throw UsageError(fmt::format("{}: has been changed since the plan was made; make a new plan",
                                   path(manifest_name)));
    }
  } catch (const Json::exception& error) {
    throw UsageError(fmt::format("{}: is damaged: {}", path(plan_name), error.what()));
  }
}

std::string Plan::making() const {
  const std::string cases = text_->cases ? fmt::format(" --cases {}", *text_->cases) : "";
  return fmt::format("wuerfel sweep plan plan/{} -o PLAN{}", sweep_file_, cases);
}

std::vector<std::string> Plan::files() const {
  std::vector<std::string> names{plan_name, manifest_name, sweep_file_};
  if (!scene_file_.empty()) names.push_back(scene_file_);
  return names;
}

Manifest::Manifest(const Plan& plan) : plan_(plan), file_(plan.path(manifest_name)) {}

std::optional<Case> Manifest::next() {
  std::string line;
  if (!std::getline(file_, line)) return std::nullopt;
  return case_of(plan_.sweep(), line);
}

std::vector<Case> spread_cases(const Plan& plan, long wanted) {
  std::vector<Case> cases;
  Manifest manifest(plan);
  wanted = std::min(wanted, plan.cases());
  while (std::optional<Case> one = manifest.next()) {
    const long before = one->number * wanted / plan.cases();
    if ((one->number + 1) * wanted / plan.cases() > before) cases.push_back(std::move(*one));
  }
  return cases;
}

}  // namespace wuerfel
