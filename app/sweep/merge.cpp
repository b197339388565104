// Makes a data set of the samples of a plan.
#include <filesystem>
#include <map>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/exit_code.h"
#include "app/output/text_output.h"
#include "app/sweep/card.h"
#include "app/sweep/dataset.h"
#include "app/sweep/dataset_files.h"
#include "app/sweep/digest.h"
#include "app/sweep/label_table.h"
#include "app/sweep/new_folder.h"
#include "app/sweep/shard.h"
#include "app/sweep/tape.h"

namespace wuerfel {

namespace {

/// The archives of one split, each begun when the one before is full.
class SplitArchives {
 public:
  SplitArchives(const NewFolder& folder, std::string split, double shard_mb)
      : folder_(folder),
        split_(std::move(split)),
        most_(static_cast<std::uint64_t>(shard_mb * 1048576.0)) {}

  /// Adds names of finished archives to `names`.
  void add(const std::string& blocks, std::vector<std::string>& names) {
    if (archive_ && size_ + blocks.size() > most_) finish(names);
    if (!archive_) archive_ = std::make_unique<TextOutput>(folder_.file(name()));
    archive_->write(blocks);
    size_ += blocks.size();
  }

  void finish(std::vector<std::string>& names) {
    if (!archive_) return;
    archive_->write(tape_end());
    archive_->finish();
    archive_.reset();
    names.push_back(name());
    ++number_;
    size_ = 0;
  }

 private:
  [[nodiscard]] std::string name() const { return fmt::format("{}-{:06}.tar", split_, number_); }

  const NewFolder& folder_;
  std::string split_;
  std::uint64_t most_;
  std::unique_ptr<TextOutput> archive_;
  std::uint64_t size_ = 0;
  int number_ = 0;
};

void require_all(const Plan& plan, const Journal& journal) {
  const long missing = plan.cases() - static_cast<long>(journal.entries().size());
  if (missing > 0) {
    throw UsageError(fmt::format("{} of {} cases are missing; make them with: wuerfel sweep run {}",
                                 missing, plan.cases(), plan.folder()));
  }
}

/// The data set while it grows.
class Merge {
 public:
  Merge(const Plan& plan, NewFolder& folder) : plan_(plan), folder_(folder), table_(plan.sweep()) {}

  void add(const Case& one, const Entry& entry) {
    if (!entry.error.empty()) {
      failures_ +=
          nlohmann::ordered_json{{"case", one.number}, {"id", one.id}, {"error", entry.error}}
              .dump()
          + "\n";
      ++counts_.failed;
      return;
    }
    const std::string blocks = read_sample(entry);
    table_.add(nlohmann::ordered_json::parse(files_in(blocks).front().bytes));
    archives_.try_emplace(one.split, folder_, one.split, plan_.sweep().files.shard_mb)
        .first->second.add(blocks, names_);
    ++counts_.samples;
  }

  DatasetCounts finish() {
    for (auto& [split, archives] : archives_)
      archives.finish(names_);
    write("labels.csv", table_.csv());
    write("labels.npz", table_.npz());
    write("card.md", card(plan_, table_, counts_));
    if (counts_.failed > 0) write("failed.jsonl", failures_);
    std::filesystem::create_directory(folder_.file(plan_folder));
    for (const std::string& name : plan_.files())
      write(std::string(plan_folder) + "/" + name, scene_text(plan_.path(name)).text);
    write_sums();
    return counts_;
  }

 private:
  void write(const std::string& name, const std::string& bytes) {
    write_text(folder_.file(name), bytes);
    names_.push_back(name);
  }

  // As `sha256sum -c` reads it.
  void write_sums() {
    std::string sums;
    for (const std::string& name : names_)
      sums += fmt::format("{}  {}\n", sha256_of_file(folder_.file(name)), name);
    write_text(folder_.file(sums_name), sums);
  }

  const Plan& plan_;
  NewFolder& folder_;
  LabelTable table_;
  std::map<std::string, SplitArchives> archives_;
  std::vector<std::string> names_;
  std::string failures_;
  DatasetCounts counts_;
};

}  // namespace

DatasetCounts merge_dataset(const Plan& plan, const std::string& folder, const StopSignal& stop) {
  const Journal journal(plan);
  require_all(plan, journal);
  NewFolder dataset(folder);
  Merge merge(plan, dataset);
  Manifest manifest(plan);
  while (const std::optional<Case> one = manifest.next()) {
    stop.check();
    merge.add(*one, journal.entries().at(one->number));
  }
  const DatasetCounts counts = merge.finish();
  dataset.commit();
  return counts;
}

}  // namespace wuerfel
