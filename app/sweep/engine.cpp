// What the engine that started the program says of its part of the work.
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "app/cli/argument.h"
#include "app/cli/exit_code.h"
#include "app/sweep/sweep_run.h"

namespace wuerfel {

namespace {

std::optional<long> whole_number(std::string_view text) {
  long value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || stop != text.data() + text.size())
    return std::nullopt;
  return value;
}

std::optional<long> variable(const char* name) {
  const char* text = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): before any thread
  return text == nullptr ? std::nullopt : whole_number(text);
}

Shard checked(const Shard& shard, const std::string& origin) {
  constexpr long most = 1'000'000;
  if (shard.count < 1 || shard.count > most) {
    throw UsageError(
        fmt::format("{}: {} is no number of shards of 1 to {}", origin, shard.count, most));
  }
  if (shard.index < 0 || shard.index >= shard.count) {
    throw UsageError(fmt::format("{}: there is no shard {} of {}; they are 0/{} to {}/{}", origin,
                                 shard.index, shard.count, shard.count, shard.count - 1,
                                 shard.count));
  }
  return shard;
}

/// Names by which engines tell one of several processes who it is.
struct RankVariables {
  const char* rank;
  const char* size;
};
constexpr std::array rank_variables{
    RankVariables{"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"},
    RankVariables{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
    RankVariables{"PMI_RANK", "PMI_SIZE"},
};

}  // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string index = text.substr(0, slash);
  const auto count = slash == std::string::npos
                         ? std::nullopt
                         : whole_number(std::string_view(text).substr(slash + 1));
  const auto sequence = variable("PARALLEL_SEQ");
  const auto number = index == "*" && sequence ? std::optional(*sequence - 1) : whole_number(index);
  if (!number || !count) {
    throw UsageError(fmt::format(
        "--shard: '{}' is not I/N with I from 0 to N-1 (or */N in a job of GNU parallel)", text));
  }
  return checked({*number, *count}, "--shard");
}

std::optional<EngineShard> shard_of_engine() {
  if (const auto id = variable("SLURM_ARRAY_TASK_ID")) {
    const auto count = variable("SLURM_ARRAY_TASK_COUNT");
    const long step = std::max(1L, variable("SLURM_ARRAY_TASK_STEP").value_or(1));
    const long index = (*id - variable("SLURM_ARRAY_TASK_MIN").value_or(0)) / step;
    return EngineShard{checked({index, count.value_or(1)}, "SLURM_ARRAY_TASK_ID"),
                       "SLURM_ARRAY_TASK_ID"};
  }
  for (const auto& [rank, size] : rank_variables) {
    const auto index = variable(rank);
    const auto count = variable(size);
    if (index && count && *count > 1) return EngineShard{checked({*index, *count}, rank), rank};
  }
  return std::nullopt;
}

double parse_time_span(const std::string& option, const std::string& text) {
  const auto refuse = [&]() -> double {
    throw UsageError(fmt::format("{}: '{}' is no time, as 3h50m, 90m or 5400", option, text));
  };
  if (text.find_first_not_of("0123456789.hms") != std::string::npos) return refuse();
  double sum = 0.0;
  std::string number;
  std::string_view units = "hms";
  for (const char c : text) {
    const std::size_t unit = units.find(c);
    if (unit == std::string_view::npos) {
      number += c;
      continue;
    }
    if (number.empty()) return refuse();
    sum += parse_time(option, number) * (c == 'h' ? 3600.0 : c == 'm' ? 60.0 : 1.0);
    number.clear();
    units.remove_prefix(unit + 1);
  }
  if (!number.empty()) {
    if (sum > 0.0) return refuse();
    sum = parse_time(option, number);
  }
  return sum;
}

}  // namespace wuerfel
