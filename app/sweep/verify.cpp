// Makes samples of a data set again.
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include <fmt/format.h>

#include "app/cli/exit_code.h"
#include "app/cli/failure.h"
#include "app/sweep/dataset.h"
#include "app/sweep/dataset_files.h"
#include "app/sweep/digest.h"
#include "app/sweep/sample.h"
#include "app/sweep/tape.h"
#include "core/work_in_order.h"
#include "render/error.h"
#include "render/files/png.h"
#include "render/raster/compare.h"

namespace wuerfel {

namespace {

namespace fs = std::filesystem;

// Which cases are looked at.
std::vector<Case> chosen_cases(const Plan& plan, const VerifyChoice& choice) {
  if (choice.id.empty())
    return spread_cases(plan, choice.sample > 0 ? choice.sample : plan.cases());
  std::vector<Case> cases;
  Manifest manifest(plan);
  while (std::optional<Case> one = manifest.next())
    if (one->id == choice.id) cases.push_back(std::move(*one));
  if (cases.empty()) throw UsageError(fmt::format("there is no sample {}", choice.id));
  return cases;
}

using Files = std::map<std::string, std::string>;

/// Samples of the data set by id, of those that are wanted.
std::map<std::string, Files> stored_samples(const std::string& folder,
                                            const std::set<std::string>& ids) {
  std::set<fs::path> archives;
  for (const auto& file : fs::directory_iterator(folder))
    if (file.path().extension() == ".tar") archives.insert(file.path());
  std::map<std::string, Files> samples;
  for (const fs::path& path : archives) {
    TapeReader archive(path.string());
    while (std::optional<TapeFile> file = archive.next()) {
      const std::string id = file->name.substr(0, file->name.find('.'));
      if (ids.contains(id)) samples[id][file->name] = std::move(file->bytes);
    }
  }
  return samples;
}

std::set<std::string> failed_ids(const std::string& folder) {
  std::set<std::string> ids;
  std::ifstream file(folder + "/failed.jsonl");
  for (std::string line; std::getline(file, line);) {
    const std::size_t start = line.find("\"id\":\"");
    if (start != std::string::npos) ids.insert(line.substr(start + 6, 16));
  }
  return ids;
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

enum class Likeness { same, near, different };

Likeness likeness(const std::string& name, const std::string& stored, const std::string& made) {
  if (stored == made) return Likeness::same;
  if (!name.ends_with(".first.png")) return Likeness::different;
  try {
    const auto comparison =
        compare_images(decode_png(bytes_of(stored)).image, decode_png(bytes_of(made)).image);
    return comparison.verdict == CompareVerdict::different ? Likeness::different : Likeness::near;
  } catch (const RenderError&) {
    return Likeness::different;
  }
}

/// What is to be said of one sample.
struct Finding {
  std::vector<std::string> differences;
  bool near = false;
};

Finding compare(const std::string& id, const Files& stored, const std::vector<TapeFile>& made) {
  Finding finding;
  if (stored.empty()) finding.differences.push_back(id + ": is missing");
  if (stored.size() != made.size() && !stored.empty()) {
    finding.differences.push_back(
        fmt::format("{}: has {} files instead of {}", id, stored.size(), made.size()));
  }
  for (const TapeFile& file : made) {
    const auto found = stored.find(file.name);
    if (found == stored.end()) continue;
    const Likeness like = likeness(file.name, found->second, file.bytes);
    if (like == Likeness::different) finding.differences.push_back(file.name + ": differs");
    finding.near = finding.near || like == Likeness::near;
  }
  return finding;
}

// Against the sums that came along, where all is asked for.
void check_sums(const std::string& folder, std::vector<std::string>& differences) {
  constexpr std::size_t digits = 64;
  std::ifstream sums(folder + "/" + sums_name);
  if (!sums) throw UsageError(fmt::format("{}: holds no {}: it is no data set", folder, sums_name));
  for (std::string line; std::getline(sums, line);) {
    const std::string name = line.substr(std::min(digits + 2, line.size()));
    const std::string path = fmt::format("{}/{}", folder, name);
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) {
      differences.push_back(name + ": is missing");
    } else if (sha256_of_file(path) != line.substr(0, digits)) {
      differences.push_back(name + ": is not what its sum says");
    }
  }
}

}  // namespace

VerifyReport verify_dataset(const std::string& folder,
                            const VerifyChoice& choice,
                            const StopSignal& stop) {
  VerifyReport report;
  check_sums(folder, report.differences);
  if (!report.differences.empty()) return report;
  const Plan plan(folder + "/" + plan_folder);
  const std::vector<Case> cases = chosen_cases(plan, choice);
  std::set<std::string> ids;
  for (const Case& one : cases)
    ids.insert(one.id);
  const std::map<std::string, Files> samples = stored_samples(folder, ids);
  const std::set<std::string> failed = failed_ids(folder);
  SampleMaker maker(plan.sweep(), stop);
  maker.prepare();
  const auto finding_of = [&](int i) {
    const std::string& id = cases[i].id;
    const auto stored = samples.find(id);
    try {
      return compare(id, stored == samples.end() ? Files{} : stored->second, maker.files(cases[i]));
    } catch (const OutputError&) {
      throw;
    } catch (const std::exception& error) {
      if (failed.contains(id)) return Finding{};
      return Finding{{fmt::format("{}: {}", id, error.what())}, false};
    }
  };
  const Workforce workforce{thread_count(choice.threads), [&stop] { stop.check(); }};
  for (Finding& finding : work_on_each(workforce, static_cast<int>(cases.size()), finding_of)) {
    for (std::string& difference : finding.differences)
      report.differences.push_back(std::move(difference));
    if (finding.near) ++report.near;
    ++report.checked;
  }
  return report;
}

}  // namespace wuerfel
