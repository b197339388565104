#include "core/scene/suggestion.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace wuerfel {
namespace {

constexpr std::size_t longest_list = 20;
constexpr std::size_t longest_word = 100;  // longer ones are not misspellings of anything

/// Fewest insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// [Damerau 1964], restricted form.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> before_last(width);
  std::vector<std::size_t> last(width);
  std::vector<std::size_t> current(width);
  for (std::size_t j = 0; j < width; ++j) {
    current[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, current);
    current[0] = i;
    for (std::size_t j = 1; j < width; ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min(replaced, std::min(last[j], current[j - 1]) + 1);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], before_last[j - 2] + 1);
      }
    }
  }
  return current.back();
}

bool begins(std::string_view a, std::string_view b) {
  return std::min(a.size(), b.size()) >= 3 && (a.starts_with(b) || b.starts_with(a));
}

/// Words of which one begins the other (pos, position) are as near as two slips. From `least` on it does not matter how much.
std::size_t strangeness(std::string_view wrong, std::string_view word, std::size_t least) {
  const std::size_t longer = std::max(wrong.size(), word.size());
  const std::size_t shorter = std::min(wrong.size(), word.size());
  if (begins(wrong, word)) return std::min<std::size_t>(longer - shorter, 2);
  return longer - shorter >= least ? least : edit_distance(wrong, word);
}

}  // namespace

std::string suggestion(std::string_view wrong, std::span<const std::string_view> known) {
  std::string_view nearest;
  std::size_t least = std::max<std::size_t>(2, wrong.size() / 3) + 1;
  for (const std::string_view word : known) {
    if (wrong.size() > longest_word) break;
    const std::size_t distance = strangeness(wrong, word, least);
    // A word all of whose letters would have to change is no suggestion.
    if (distance < least && distance < word.size()) {
      least = distance;
      nearest = word;
    }
  }
  if (!nearest.empty()) return fmt::format("; did you mean \"{}\"?", nearest);
  if (known.empty()) return "";
  const auto shown = known.first(std::min(known.size(), longest_list));
  return fmt::format("; known: {}{}", fmt::join(shown, ", "),
                     shown.size() < known.size() ? ", ..." : "");
}

}  // namespace wuerfel
