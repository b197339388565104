/// Values on the command line: strict readers that refuse what they do not understand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wuerfel {

struct PixelSize {
  int width = 1280;
  int height = 720;  ///< 0: as the scene asks for
};

/// A finite number that fills the whole text. `option` is named in the UsageError otherwise.
double parse_number(std::string_view option, std::string_view text);

/// A number > 0.
double parse_positive(std::string_view option, std::string_view text);

/// A whole number from `least` to `most`.
long parse_whole(std::string_view option, std::string_view text, long least, long most);

/// A number of bytes > 0 "800k", "500M", "4G", "1.5T", or in bytes, of which there are a million at least: fewer miss their unit.
double parse_bytes(std::string_view option, std::string_view text);

/// A length on paper in mm: "84mm", "3.5in", "9cm" or "240pt".
double parse_paper_length(std::string_view option, std::string_view text);

/// A number >= 0.
double parse_not_negative(std::string_view option, std::string_view text);

/// From 0 to 1e15 s.
double parse_time(std::string_view option, std::string_view text);

/// Numbers with commas between them, at least one.
std::vector<double> parse_numbers(std::string_view option, std::string_view text);

/// "1280x720": from 16 to 16384 pixels each way; "1280xauto" has the height 0.
PixelSize parse_pixel_size(std::string_view text);

/// In small letters, as far as it is ASCII.
std::string lower_case(std::string_view text);

/// Whether a file name ends so, in letters of any size; `suffix` in small ones, as in ".png".
bool has_suffix(std::string_view name, std::string_view suffix);

/// Throws UsageError where the name of a file does not end so.
void require_suffix(std::string_view option, std::string_view name, std::string_view suffix);

/// Throws UsageError where `file` is standard output, which carries something else.
void require_no_stdout(std::string_view option, std::string_view file);

/// Texts with commas between them.
std::vector<std::string> split_list(std::string_view text);

/// "a, b or c".
std::string join_choices(const std::vector<std::string>& choices);

}  // namespace wuerfel
