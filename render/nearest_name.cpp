#include "render/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace wuerfel {
namespace {

/// Levenshtein distance: the smallest number of letters to insert, remove or replace.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0U : 1U);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest_name_hint(std::string_view mistyped, std::span<const std::string_view> known) {
  const auto nearest = std::ranges::min_element(
      known, {}, [mistyped](std::string_view name) { return edit_distance(mistyped, name); });
  if (nearest != known.end() && edit_distance(mistyped, *nearest) <= (nearest->size() + 2) / 3) {
    return ", did you mean '" + std::string(*nearest) + "'?";
  }
  std::string all;
  for (const std::string_view name : known)
    all += (all.empty() ? "" : ", ") + std::string(name);
  return "; known: " + all;
}

}  // namespace wuerfel
