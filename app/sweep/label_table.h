/// The labels of all samples, column by column: labels.csv and labels.npz.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/sweep/sweep_file.h"

namespace wuerfel {

class LabelTable {
 public:
  explicit LabelTable(const Sweep& sweep);

  /// A row, from the labels of a sample (ID.json).
  void add(const nlohmann::ordered_json& sample);
  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::string npz() const;

  struct Column {
    std::string name;
    std::string table;                          ///< "values" or "labels" of the sample, or none
    std::vector<nlohmann::ordered_json> cells;  ///< null: there is none
  };
  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

 private:
  std::vector<Column> columns_;
};

}  // namespace wuerfel
