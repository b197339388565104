#include "render/raster/row_set.h"

#include <algorithm>

namespace wuerfel {

void RowSet::add(RowRange rows) {
  if (rows.begin >= rows.end) return;
  const auto first = std::ranges::lower_bound(ranges_, rows.begin, {}, &RowRange::end);
  auto last = first;
  for (; last != ranges_.end() && last->begin <= rows.end; ++last) {
    rows = {std::min(rows.begin, last->begin), std::max(rows.end, last->end),
            std::min(rows.left, last->left), std::max(rows.right, last->right)};
  }
  ranges_.insert(ranges_.erase(first, last), rows);
}

void RowSet::add(const RowSet& rows) {
  for (const RowRange& range : rows.ranges_)
    add(range);
}

bool RowSet::touches(const RowRange& rows) const {
  return std::ranges::any_of(ranges_, [&](const RowRange& range) {
    return range.begin < rows.end && rows.begin < range.end;
  });
}

}  // namespace wuerfel
