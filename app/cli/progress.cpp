#include "app/cli/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <unistd.h>
#include <utility>

#include <fmt/core.h>

#include "app/cli/streams.h"

namespace wuerfel {

namespace {

constexpr int bar_width = 30;
constexpr double patience = 1.0;         // s: a log tells nothing of what is over at once
constexpr double line_growth = 4.0;      // of the time until the next line of a log
constexpr double redraw_interval = 0.1;  // s: faster than the eye needs would only cost time

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe)
  return value == nullptr ? std::string_view{} : std::string_view{value};
}

std::string clock_text(double seconds) {
  constexpr double year = 365.0 * 24.0 * 3600.0;
  if (seconds > year) return fmt::format("{:.2g} years", seconds / year);
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

// Counts in full, also where they have more digits.
std::string number_text(double value, int digits) {
  return value >= 1e3 && value < 1e9 ? fmt::format("{:.0f}", value)
                                     : fmt::format("{:.{}g}", value, digits);
}

}  // namespace

bool LogSchedule::due(double share, double elapsed) {
  const int tenth = static_cast<int>(10.0 * share + 1e-9);
  if ((tenth <= last_tenth_ && elapsed < next_line_) || elapsed < patience) return false;
  last_tenth_ = std::max(last_tenth_, tenth);
  while (next_line_ <= elapsed)
    next_line_ *= line_growth;
  return true;
}

Progress::Style Progress::style_for_stderr(bool quiet) {
  if (quiet) return Style::silent;
  if (isatty(STDERR_FILENO) == 0 || environment("TERM") == "dumb") return Style::lines;
  return environment("NO_COLOR").empty() ? Style::coloured_bar : Style::bar;
}

Progress::Progress(Style style, std::string label, double total, std::string unit)
    : style_(style), label_(std::move(label)), total_(total), unit_(std::move(unit)) {}

Progress::~Progress() { end(); }

void Progress::end() {
  const bool is_bar = style_ == Style::bar || style_ == Style::coloured_bar;
  if (is_bar && last_drawn_ >= 0.0) say("\n");
  style_ = Style::silent;
}

void Progress::reached(double done) {
  if (style_ == Style::silent || total_ <= 0.0) return;
  if (style_ != Style::lines) {
    const bool due = last_drawn_ < 0.0 || watch_.wall() - last_drawn_ >= redraw_interval;
    if (due || done >= total_) draw_bar(done);
    return;
  }
  if (schedule_.due(done / total_, watch_.wall())) say(text(done) + "\n");
}

std::string Progress::text(double done) const {
  const double elapsed = watch_.wall();
  const double share = std::min(1.0, done / total_);
  const double rate = elapsed > 0.0 ? done / elapsed : 0.0;
  std::string text =
      fmt::format("{} {:3.0f} %  {} of {} {}  {} {}/s", label_, 100.0 * share, number_text(done, 4),
                  number_text(total_, 4), unit_, number_text(rate, 3), unit_);
  if (share < 1.0 && rate > 0.0) {
    text += fmt::format("  {} left", clock_text((total_ - done) / rate));
  } else {
    text += fmt::format("  in {}", clock_text(elapsed));
  }
  return text;
}

void Progress::draw_bar(double done) {
  last_drawn_ = watch_.wall();
  const int filled = static_cast<int>(bar_width * std::min(1.0, done / total_));
  const std::string full(static_cast<std::size_t>(filled), '#');
  const std::string rest(static_cast<std::size_t>(bar_width - filled), '.');
  const bool coloured = style_ == Style::coloured_bar;
  say(fmt::format("\r[{}{}{}{}] {}\x1b[K", coloured ? "\x1b[32m" : "", full,
                  coloured ? "\x1b[0m" : "", rest, text(done)));
}

}  // namespace wuerfel
