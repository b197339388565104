#include "app/sweep/label_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "app/output/tables.h"
#include "app/sweep/npy.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;
using Cells = std::vector<Json>;

// Texts bare, all else as JSON.
std::string text_of(const Json& cell) {
  if (cell.is_null()) return "";
  return cell.is_string() ? cell.get<std::string>() : cell.dump();
}

template <class Is>
bool all(const Cells& cells, Is is) {
  return std::ranges::all_of(cells, is);
}

// Numbers with gaps are doubles, with NaN in the gaps; what is mixed is text.
std::string npy_of(const Cells& cells) {
  if (!cells.empty() && all(cells, [](const Json& c) { return c.is_boolean(); })) {
    std::vector<bool> values;
    for (const Json& cell : cells)
      values.push_back(cell);
    return wuerfel::npy_of(values);
  }
  if (all(cells, [](const Json& c) { return c.is_number_integer(); })) {
    std::vector<std::int64_t> values;
    for (const Json& cell : cells)
      values.push_back(cell);
    return wuerfel::npy_of(values);
  }
  if (all(cells, [](const Json& c) { return c.is_number() || c.is_null(); })) {
    std::vector<double> values;
    for (const Json& cell : cells) {
      values.push_back(cell.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                      : cell.get<double>());
    }
    return wuerfel::npy_of(values, {values.size()});
  }
  std::vector<std::string> values;
  for (const Json& cell : cells)
    values.push_back(text_of(cell));
  return wuerfel::npy_of(values);
}

}  // namespace

LabelTable::LabelTable(const Sweep& sweep) {
  for (const char* name : {"id", "case", "split"})
    columns_.push_back({name, "", {}});
  for (const Variable& variable : sweep.variables)
    columns_.push_back({variable.key, "values", {}});
  for (const CheckColumn column : sweep.labels.check)
    columns_.push_back({std::string(to_string(column)), "labels", {}});
  for (const RunColumn column : sweep.labels.run)
    columns_.push_back({std::string(to_string(column)), "labels", {}});
}

void LabelTable::add(const Json& sample) {
  for (Column& column : columns_) {
    const Json& from = column.table.empty() ? sample : sample.at(column.table);
    column.cells.push_back(from.at(column.name));
  }
}

std::string LabelTable::csv() const {
  std::string text;
  for (const Column& column : columns_)
    text += (text.empty() ? "" : ",") + csv_cell(column.name);
  text += '\n';
  for (std::size_t row = 0; row < columns_.front().cells.size(); ++row) {
    for (std::size_t c = 0; c < columns_.size(); ++c)
      text += (c > 0 ? "," : "") + csv_cell(text_of(columns_[c].cells[row]));
    text += '\n';
  }
  return text;
}

std::string LabelTable::npz() const {
  NpzFile file;
  for (const Column& column : columns_)
    file.add(column.name, npy_of(column.cells));
  return file.finish();
}

}  // namespace wuerfel
