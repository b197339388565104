#include "tests/support/reference_program.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace wuerfel::test {
namespace {

using Rows = std::map<int, std::map<int, std::vector<double>>>;  ///< row -> block -> coefficients

Rows rows_of(const nlohmann::json& triplets, int block_size) {
  Rows rows;
  for (const auto& t : triplets) {
    const int column = t[1].get<int>();
    auto& block = rows[t[0].get<int>()][column / block_size];
    block.resize(static_cast<std::size_t>(block_size));
    block[static_cast<std::size_t>(column % block_size)] = t[2].get<double>();
  }
  return rows;
}

void add_rows(const nlohmann::json& triplets,
              const std::vector<double>& bounds,
              bool equality,
              QuadraticProgram& program) {
  Rows rows = rows_of(triplets, program.block_size);
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (equality) {
      program.add_equality(bounds[i]);
    } else {
      program.add_inequality(bounds[i]);
    }
    for (const auto& [block, coefficients] : rows[static_cast<int>(i)])
      program.add_entry(block, coefficients);
  }
}

nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  return nlohmann::json::parse(file);
}

}  // namespace

ReferenceProgram read_reference_program(const std::string& stem) {
  const nlohmann::json data = read_json(std::filesystem::path(TEST_DATA) / "qp" / (stem + ".json"));
  ReferenceProgram reference;
  reference.name = stem;
  QuadraticProgram& program = reference.program;
  program.clear(stem.starts_with("qp_rods") ? 2 : 3);
  program.mass = data.at("M_diag").get<std::vector<double>>();
  program.target = data.at("F").get<std::vector<double>>();
  add_rows(data.at("E_triplets"), data.at("d").get<std::vector<double>>(), true, program);
  add_rows(data.at("J_triplets"), data.at("b").get<std::vector<double>>(), false, program);
  for (const auto& expected : data.at("expected")) {
    const auto type = expected.at("type").get<std::string>();
    const auto& value = expected.at("value");
    if (type == "qp_primal") reference.x = value.get<std::vector<double>>();
    if (type == "qp_objective") reference.objective = value.get<double>();
    if (type != "qp_multipliers") continue;
    reference.unique = expected.at("unique").get<bool>();
    for (const char* part : {"nu", "lambda"}) {
      for (const auto& v : value.at(part))
        reference.least_norm_multipliers.push_back(v.get<double>());
    }
  }
  return reference;
}

std::vector<std::string> reference_program_names() {
  std::vector<std::string> names;
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(TEST_DATA) / "qp"))
    if (file.path().extension() == ".json") names.push_back(file.path().stem().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace wuerfel::test
