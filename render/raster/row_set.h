/// RowSet: some rows of a picture, or of some of its columns.
#pragma once

#include <vector>

#include "render/raster/image.h"

namespace wuerfel {

class RowSet {
 public:
  RowSet() = default;
  RowSet(RowRange rows) { add(rows); }  // NOLINT(google-explicit-constructor): a range is a set

  void add(RowRange rows);
  void add(const RowSet& rows);
  /// Whether one of the rows is in the set.
  bool touches(const RowRange& rows) const;
  /// From top to bottom, apart from each other; each with the columns of all rows in it.
  const std::vector<RowRange>& ranges() const { return ranges_; }
  friend bool operator==(const RowSet&, const RowSet&) = default;

 private:
  std::vector<RowRange> ranges_;
};

}  // namespace wuerfel
