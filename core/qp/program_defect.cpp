#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "core/qp/qp_solver.h"

namespace wuerfel {

/// v * 0 is 0 for every number and not a number for everything else; eight sums keep the adders
/// busy.
bool all_finite(const std::vector<double>& values) {
  std::array<double, 8> sum{};
  std::size_t i = 0;
  for (; i + sum.size() <= values.size(); i += sum.size()) {
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += values[i + k] * 0.0;
  }
  for (; i < values.size(); ++i)
    sum[0] += values[i] * 0.0;
  return std::accumulate(sum.begin(), sum.end(), 0.0) == 0.0;
}

namespace {

std::string_view size_defect(const QuadraticProgram& p) {
  const std::size_t rows = p.bound.size();
  if (p.block_size < 1) return "the block size is not positive";
  if (p.mass.size() % p.block_size != 0) return "the masses do not fill whole blocks";
  if (p.target.size() != p.mass.size()) return "there are not as many targets as masses";
  if (p.force_min.size() != rows || p.force_max.size() != rows)
    return "a row lacks its range of forces";
  if (p.row_start.size() != rows + 1 || p.row_start.front() != 0)
    return "the row starts do not fit the rows";
  if (!std::ranges::is_sorted(p.row_start)) return "the row starts do not increase";
  if (!p.row_name.empty() && p.row_name.size() != rows) return "not all rows have a name";
  if (p.entries() != std::ssize(p.entry_block)) return "the row starts do not fit the entries";
  if (p.coefficients.size() != p.entry_block.size() * p.block_size)
    return "the coefficients do not fit the entries";
  return {};
}

bool repeats_a_block(const int* first, const int* last) {
  if (last - first == 2) return first[0] == first[1];  // as nearly all rows have
  for (const int* e = first; e < last; ++e)
    if (std::find(first, e, *e) != e) return true;
  return false;
}

std::string_view entry_defect(const QuadraticProgram& p) {
  if (!p.entry_block.empty()) {
    const auto [least, largest] = std::ranges::minmax(p.entry_block);
    if (least < 0 || largest >= p.blocks()) return "a row names a block that does not exist";
  }
  const int* block = p.entry_block.data();
  for (int row = 0; row < p.rows(); ++row) {
    if (repeats_a_block(block + p.row_start[row], block + p.row_start[row + 1]))
      return "a row names a block twice";
  }
  return {};
}

std::string_view value_defect(const QuadraticProgram& p) {
  if (!all_finite(p.mass) || !std::ranges::all_of(p.mass, [](double m) { return m > 0.0; }))
    return "a mass is not a positive number";
  if (!all_finite(p.target)) return "a target is not a number";
  if (!all_finite(p.bound)) return "a bound is not a number";
  if (!all_finite(p.coefficients)) return "a coefficient is not a number";
  // Written so that NaN is caught as well.
  if (!std::ranges::all_of(p.force_min, [](double f) { return f <= 0.0; }))
    return "a smallest force is not <= 0";
  if (!std::ranges::all_of(p.force_max, [](double f) { return f >= 0.0; }))
    return "a largest force is not >= 0";
  return {};
}

}  // namespace

std::string_view defect(const QuadraticProgram& program) {
  for (auto* find : {&size_defect, &entry_defect, &value_defect})
    if (const std::string_view found = find(program); !found.empty()) return found;
  return {};
}

}  // namespace wuerfel
