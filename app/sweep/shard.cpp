#include "app/sweep/shard.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <filesystem>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/exit_code.h"
#include "app/sweep/digest.h"
#include "app/sweep/plan_files.h"
#include "app/sweep/tape.h"
#include "render/error.h"

namespace wuerfel {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t most_waiting = std::size_t{1} << 20U;  // bytes
constexpr double longest_wait = 1.0;                         // s

[[noreturn]] void fail(const std::string& path) {
  throw OutputError(
      fmt::format("cannot write {}: {}", path, std::generic_category().message(errno)));
}

void write_all(int descriptor, std::string_view bytes, const std::string& path) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string archive_of(const std::string& journal) {
  return fs::path(journal).replace_extension(".tar").string();
}

Entry entry_of(const Json& json, const std::string& archive) {
  Entry entry;
  entry.number = json.at("case");
  entry.id = json.at("id");
  entry.archive = archive;
  if (json.contains("error")) {
    entry.error = json["error"];
    return entry;
  }
  entry.offset = json.at("offset");
  entry.length = json.at("length");
  entry.crc32 = json.at("crc32");
  entry.cpu_s = json.at("cpu_s");
  return entry;
}

// A sample counts before an error, else who was first.
void book(Entry entry, std::map<long, Entry>& entries) {
  const auto [place, is_new] = entries.try_emplace(entry.number, entry);
  if (!is_new && !place->second.error.empty() && entry.error.empty())
    place->second = std::move(entry);
}

std::vector<std::string> journals_of(const Plan& plan) {
  std::vector<std::string> paths;
  std::error_code error;
  for (const auto& file : fs::directory_iterator(plan.path(shards_folder), error))
    if (file.path().extension() == ".jsonl") paths.push_back(file.path().string());
  std::ranges::sort(paths);
  return paths;
}

}  // namespace

Journal::Journal(const Plan& plan) {
  for (const std::string& path : journals_of(plan))
    read(path, plan);
}

// A line that was cut off says nothing, nor do those behind it.
void Journal::read(const std::string& path, const Plan& plan) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const Json head = Json::parse(line, nullptr, false);
  if (!head.is_object() || file.eof()) return;
  if (head.value("plan", "") != plan.hash()) {
    throw UsageError(
        fmt::format("{}: belongs to another plan; remove it or take its own plan", path));
  }
  std::error_code error;
  const std::string archive = archive_of(path);
  const auto size = fs::file_size(archive, error);
  while (std::getline(file, line) && !file.eof()) {
    const Json json = Json::parse(line, nullptr, false);
    try {
      Entry entry = entry_of(json, archive);
      if (!entry.error.empty() || (!error && entry.offset + entry.length <= size))
        book(std::move(entry), entries_);
    } catch (const Json::exception&) {
      return;
    }
  }
}

std::string read_sample(const Entry& entry) {
  std::ifstream file(entry.archive, std::ios::binary);
  std::string blocks(entry.length, '\0');
  file.seekg(static_cast<std::streamoff>(entry.offset));
  file.read(blocks.data(), static_cast<std::streamsize>(blocks.size()));
  if (!file || crc32_of(blocks) != entry.crc32) {
    throw UsageError(fmt::format(
        "{}: sample {} is damaged; remove the file and its .jsonl, and run the sweep again",
        entry.archive, entry.id));
  }
  return blocks;
}

ShardWriter::~ShardWriter() {
  try {
    flush();
  } catch (const std::exception&) {  // what was not written is made again
  }
  if (archive_ >= 0) ::close(archive_);
  if (journal_ >= 0) ::close(journal_);
}

void ShardWriter::open() {
  if (archive_ >= 0) return;
  std::error_code error;
  fs::create_directories(plan_.path(shards_folder), error);
  constexpr int most_runs = 1'000'000;
  for (int run = 0; run < most_runs && archive_ < 0; ++run) {
    name_ = fmt::format("{}/{}/{:05}-of-{:05}.{:04}.tar", plan_.folder(), shards_folder,
                        shard_.index, shard_.count, run);
    archive_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (archive_ < 0 && errno != EEXIST) fail(name_);
  }
  const std::string journal = fs::path(name_).replace_extension(".jsonl").string();
  journal_ = ::open(journal.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (journal_ < 0) fail(journal);
  flushed_ = now();
  lines_ =
      Json{{"plan", plan_.hash()}, {"shard", shard_.index}, {"of", shard_.count}}.dump() + "\n";
}

void ShardWriter::add(const Case& one, const std::string& blocks, double cpu_s) {
  open();
  note(Json{{"case", one.number},
            {"id", one.id},
            {"offset", offset_ + waiting_.size()},
            {"length", blocks.size()},
            {"crc32", crc32_of(blocks)},
            {"cpu_s", cpu_s}}
           .dump());
  waiting_ += blocks;
  if (waiting_.size() >= most_waiting || now() - flushed_ >= wait_) flush();
}

void ShardWriter::add_failure(const Case& one, const std::string& error) {
  open();
  note(Json{{"case", one.number}, {"id", one.id}, {"error", error}}.dump(
      -1, ' ', false, Json::error_handler_t::replace));
}

void ShardWriter::note(const std::string& line) { lines_ += line + "\n"; }

void ShardWriter::flush() {
  if (archive_ < 0 || lines_.empty()) return;
  // Buffers are swapped, not made anew: memory stays as it is for millions of samples.
  blocks_.clear();
  journal_lines_.clear();
  blocks_.swap(waiting_);
  journal_lines_.swap(lines_);
  write_all(archive_, blocks_, name_);
  if (::fsync(archive_) != 0) fail(name_);
  write_all(journal_, journal_lines_, name_);
  if (::fsync(journal_) != 0) fail(name_);
  offset_ += blocks_.size();
  flushed_ = now();
  wait_ = std::min(2.0 * wait_, longest_wait);
}

}  // namespace wuerfel
