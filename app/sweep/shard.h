/// Shards: where runs of a sweep put their samples. Every run has files of its own, so that runs
/// that were killed, sent again, or do the same twice are in nobody's way: what counts of them is
/// what their journal says and their archive holds.
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "app/sweep/case.h"
#include "app/sweep/plan.h"

namespace wuerfel {

/// A part of the cases: those whose number leaves the rest `index` when divided by `count`.
struct Shard {
  long index = 0;
  long count = 1;

  [[nodiscard]] bool holds(long number) const { return number % count == index; }
};

/// A line of a journal: a sample, or why there is none.
struct Entry {
  long number = 0;  ///< of the case
  std::string id;
  std::string archive;  ///< its path
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint32_t crc32 = 0;
  double cpu_s = 0.0;
  std::string error;  ///< not empty: the case failed
};

/// All that was made of a plan up to now, by the number of the case. A sample counts where its
/// archive is long enough for it, and before an error.
class Journal {
 public:
  /// Throws UsageError where a journal belongs to another plan.
  explicit Journal(const Plan& plan);

  [[nodiscard]] const std::map<long, Entry>& entries() const { return entries_; }

 private:
  void read(const std::string& path, const Plan& plan);

  std::map<long, Entry> entries_;
};

/// The blocks of a sample. Throws UsageError where they are not what was written.
std::string read_sample(const Entry& entry);

/// The files of one run.
class ShardWriter {
 public:
  /// Nothing is made before the first sample.
  ShardWriter(const Plan& plan, Shard shard) : plan_(plan), shard_(shard) {}
  ~ShardWriter();
  ShardWriter(const ShardWriter&) = delete;
  ShardWriter& operator=(const ShardWriter&) = delete;

  /// What comes together within a second, at first less, or 1 MB is written together: the archive first, the lines
  /// of the journal when it is safe on the disk. Throws OutputError.
  void add(const Case& one, const std::string& blocks, double cpu_s);
  void add_failure(const Case& one, const std::string& error);
  /// Writes what waits.
  void flush();

 private:
  void open();
  void note(const std::string& line);

  const Plan& plan_;
  Shard shard_;
  int archive_ = -1;  // descriptors
  int journal_ = -1;
  std::string name_;
  std::uint64_t offset_ = 0;  // of what waits
  std::string waiting_;
  std::string lines_;
  std::string blocks_;  // what is being written
  std::string journal_lines_;
  double wait_ =
      0.05;  // s, until the next flush: short at first, so that even short runs leave something
  double flushed_ = 0.0;  // s, of the machine's clock: when, never what
};

}  // namespace wuerfel
