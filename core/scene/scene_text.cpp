#include "core/scene/scene_text.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace wuerfel {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
constexpr std::string_view white_space = " \t\r\n";

std::string_view without_mark(std::string_view text) {
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

unsigned byte_at(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// Characters by their first byte (RFC 3629): how long they are and what the second byte may be. No
/// overlong forms, no surrogates, nothing beyond U+10FFFF.
struct CharacterClass {
  unsigned first_low;
  unsigned first_high;
  std::size_t length;
  unsigned second_low;
  unsigned second_high;
};
constexpr std::array<CharacterClass, 8> character_classes{{{0xc2U, 0xdfU, 2, 0x80U, 0xbfU},
                                                           {0xe0U, 0xe0U, 3, 0xa0U, 0xbfU},
                                                           {0xe1U, 0xecU, 3, 0x80U, 0xbfU},
                                                           {0xedU, 0xedU, 3, 0x80U, 0x9fU},
                                                           {0xeeU, 0xefU, 3, 0x80U, 0xbfU},
                                                           {0xf0U, 0xf0U, 4, 0x90U, 0xbfU},
                                                           {0xf1U, 0xf3U, 4, 0x80U, 0xbfU},
                                                           {0xf4U, 0xf4U, 4, 0x80U, 0x8fU}}};

/// Length of the UTF-8 character at `i`, 0 where there is none.
std::size_t character_length(std::string_view text, std::size_t i) {
  const unsigned first = byte_at(text, i);
  if (first < 0x80U) return 1;
  const auto* found = std::find_if(
      character_classes.begin(), character_classes.end(),
      [&](const CharacterClass& c) { return first >= c.first_low && first <= c.first_high; });
  if (found == character_classes.end() || i + found->length > text.size()) return 0;
  const unsigned second = byte_at(text, i + 1);
  if (second < found->second_low || second > found->second_high) return 0;
  for (std::size_t k = 2; k < found->length; ++k) {
    if ((byte_at(text, i + k) & 0xc0U) != 0x80U) return 0;
  }
  return found->length;
}

std::optional<TextFault> find_encoding_fault(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\0') return TextFault{i, "not a text: it holds a zero byte"};
    const std::size_t length = character_length(text, i);
    if (length == 0) return TextFault{i, "not UTF-8 text; save it in that encoding"};
    i += length;
  }
  return std::nullopt;
}

/// Walks over brackets and dots outside of strings and comments. On valid text it sees tokens as
/// the parsers do; what follows the first error of invalid text no parser reads.
class NestingCheck {
 public:
  NestingCheck(std::string_view text, SceneLanguage language)
      : text_(text), toml_(language == SceneLanguage::toml) {}

  /// Offset of the first bracket or dot that is too deep, npos if there is none.
  std::size_t first_too_deep() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || (toml_ && c == '\'')) {
        skip_string(c);
        continue;
      }
      if (toml_ && c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
        continue;
      }
      count(c);
      if (depth_ > deepest_nesting || dots_ > deepest_nesting) return at_;
      ++at_;
    }
    return std::string_view::npos;
  }

 private:
  void count(char c) {
    if (c == '[' || c == '{') ++depth_;
    if (c == ']' || c == '}') depth_ = std::max(depth_ - 1, 0);
    if (c == '.') {
      ++dots_;
    } else if (std::string_view("[]{}=,\n").find(c) != std::string_view::npos) {
      dots_ = 0;
    }
  }

  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool long_string = toml_ && text_.substr(at_, 3) == three;
    at_ += long_string ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\\' && quote == '"') {
        at_ += 2;
      } else if (long_string && text_.substr(at_, 3) == three) {
        at_ += 3;
        while (at_ < text_.size() && text_[at_] == quote)
          ++at_;  // up to two quotes may stand inside
        return;
      } else if (!long_string && (c == quote || c == '\n')) {
        ++at_;
        return;
      } else {
        ++at_;
      }
    }
    at_ = std::min(at_, text_.size());
  }

  std::string_view text_;
  bool toml_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int dots_ = 0;
};

}  // namespace

SceneLanguage language_of(std::string_view text, std::string_view name) {
  text = without_mark(text);
  const std::size_t first = text.find_first_not_of(white_space);
  const bool brace = first != std::string_view::npos && text[first] == '{';
  return brace || name.ends_with(".json") ? SceneLanguage::json : SceneLanguage::toml;
}

Place place_at(std::string_view text, std::size_t offset) {
  Place place{1, 1};
  const std::size_t end = std::min(offset, text.size());
  for (std::size_t i = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0; i < end;
       ++i) {
    if (text[i] == '\n') {
      ++place.line;
      place.column = 1;
    } else if ((byte_at(text, i) & 0xc0U) != 0x80U) {
      ++place.column;
    }
  }
  return place;
}

std::optional<TextFault> find_text_fault(std::string_view text, SceneLanguage language) {
  if (text.size() > longest_text) {
    return TextFault{
        0, fmt::format("too long: {} bytes, at most {} are read", text.size(), longest_text)};
  }
  std::optional<TextFault> fault = find_encoding_fault(text);
  if (fault) return fault;
  const std::size_t too_deep = NestingCheck(text, language).first_too_deep();
  if (too_deep == std::string_view::npos) return std::nullopt;
  return TextFault{too_deep,
                   fmt::format("nested too deeply: more than {} levels", deepest_nesting)};
}

void check_text(std::string_view text, SceneLanguage language, const SceneSource& source) {
  if (without_mark(text).find_first_not_of(white_space) == std::string_view::npos) {
    source.fail({1, 1}, "", "empty; a scene needs at least one [[cube]]");
  }
  const std::optional<TextFault> fault = find_text_fault(text, language);
  if (fault) source.fail(place_at(text, fault->offset), "", fault->message);
}

}  // namespace wuerfel
