#include "app/cli/argument.h"

#include <charconv>
#include <cmath>

#include <fmt/core.h>

#include "app/cli/exit_code.h"

namespace wuerfel {

namespace {

constexpr int smallest_picture = 16;
constexpr int largest_picture = 16384;

bool read_whole(std::string_view text, auto& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end;
}

}  // namespace

double parse_number(std::string_view option, std::string_view text) {
  double value = 0.0;
  if (!read_whole(text, value) || !std::isfinite(value)) {
    throw UsageError(fmt::format("{}: '{}' is not a number", option, text));
  }
  return value;
}

double parse_positive(std::string_view option, std::string_view text) {
  const double value = parse_number(option, text);
  if (value <= 0.0) throw UsageError(fmt::format("{}: {} is not greater than 0", option, text));
  return value;
}

long parse_whole(std::string_view option, std::string_view text, long least, long most) {
  // 1e3 and 1000.0 are whole numbers, too.
  double value = 0.0;
  const bool fits = read_whole(text, value) && value >= static_cast<double>(least)
                    && value <= static_cast<double>(most) && value == std::floor(value);
  if (!fits) {
    throw UsageError(
        fmt::format("{}: '{}' is no whole number of {} to {}", option, text, least, most));
  }
  return static_cast<long>(value);
}

double parse_bytes(std::string_view option, std::string_view text) {
  constexpr std::string_view units = "kMGT";
  const std::size_t power = units.find(text.empty() ? ' ' : text.back());
  const bool has_unit = power != std::string_view::npos;
  double value = 0.0;
  if (!read_whole(text.substr(0, text.size() - (has_unit ? 1 : 0)), value) || !std::isfinite(value)
      || value <= 0.0)
    throw UsageError(fmt::format("{}: '{}' is no size, as 500M or 4G", option, text));
  if (has_unit) return std::pow(1000.0, static_cast<double>(power + 1)) * value;
  constexpr double least_bytes = 1e6;
  if (value < least_bytes) {
    throw UsageError(
        fmt::format("{0}: '{1}' are bytes, too few for any run; did you mean {1}M?", option, text));
  }
  return value;
}

double parse_paper_length(std::string_view option, std::string_view text) {
  constexpr double shortest = 1.0;    // mm
  constexpr double longest = 5080.0;  // mm, of a page of PDF
  struct Unit {
    std::string_view name;
    double mm;
  };
  for (const auto& [name, mm] :
       {Unit{"mm", 1.0}, Unit{"cm", 10.0}, Unit{"in", 25.4}, Unit{"pt", 25.4 / 72.0}}) {
    if (!text.ends_with(name)) continue;
    const double length = mm * parse_positive(option, text.substr(0, text.size() - name.size()));
    if (length >= shortest && length <= longest) return length;
    throw UsageError(
        fmt::format("{}: {} is not between {} mm and {} mm", option, text, shortest, longest));
  }
  throw UsageError(fmt::format("{}: '{}' is no length in mm, cm, in or pt, as 84mm", option, text));
}

double parse_not_negative(std::string_view option, std::string_view text) {
  const double value = parse_number(option, text);
  if (value < 0.0) throw UsageError(fmt::format("{}: {} is less than 0", option, text));
  return value;
}

double parse_time(std::string_view option, std::string_view text) {
  constexpr double longest = 1e15;
  const double value = parse_number(option, text);
  if (value < 0.0) throw UsageError(fmt::format("{}: {} is before the start at 0", option, text));
  if (value > longest)
    throw UsageError(fmt::format("{}: {} s are more than {:.0e}", option, text, longest));
  return value;
}

std::vector<double> parse_numbers(std::string_view option, std::string_view text) {
  std::vector<double> numbers;
  for (const std::string& part : split_list(text))
    numbers.push_back(parse_number(option, part));
  return numbers;
}

PixelSize parse_pixel_size(std::string_view text) {
  const std::size_t cross = text.find('x');
  PixelSize size;
  const bool is_auto = text.ends_with("xauto");
  if (is_auto) size.height = 0;
  if (cross == std::string_view::npos || !read_whole(text.substr(0, cross), size.width)
      || !(is_auto || read_whole(text.substr(cross + 1), size.height))) {
    throw UsageError(
        fmt::format("--size: '{}' is not WIDTHxHEIGHT, as in 1280x720 or 1280xauto", text));
  }
  for (const int side : {size.width, is_auto ? size.width : size.height}) {
    if (side < smallest_picture || side > largest_picture) {
      throw UsageError(fmt::format("--size: {} pixels is not between {} and {}", side,
                                   smallest_picture, largest_picture));
    }
  }
  return size;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

bool has_suffix(std::string_view name, std::string_view suffix) {
  return lower_case(name).ends_with(suffix);
}

void require_no_stdout(std::string_view option, std::string_view file) {
  if (file == "-")
    throw UsageError(fmt::format("{}: standard output carries the answer: name a file", option));
}

void require_suffix(std::string_view option, std::string_view name, std::string_view suffix) {
  if (!has_suffix(name, suffix))
    throw UsageError(fmt::format("{}: '{}' does not end in {}", option, name, suffix));
}

std::vector<std::string> split_list(std::string_view text) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t comma = text.find(',');
    parts.emplace_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

std::string join_choices(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) text += i + 1 == choices.size() ? " or " : ", ";
    text += choices[i];
  }
  return text;
}

}  // namespace wuerfel
