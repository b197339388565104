#include "tests/support/motion_programs.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

namespace wuerfel::test {
namespace {

constexpr std::size_t first_entry = 2;  ///< of a row, after its bound and kind

ZooProgram program_of(const nlohmann::json& data) {
  ZooProgram zoo;
  zoo.name = data.at("name").get<std::string>();
  QuadraticProgram& program = zoo.program;
  program.clear(3);
  program.mass = data.at("M_diag").get<std::vector<double>>();
  program.target = data.at("F").get<std::vector<double>>();
  for (const auto& row : data.at("rows")) {
    const double bound = row.at(0).get<double>();
    if (row.at(1) == "equality") {
      program.add_equality(bound);
    } else {
      program.add_inequality(bound);
    }
    for (std::size_t k = first_entry; k < row.size(); ++k) {
      const std::vector<double> values{row[k].at(1), row[k].at(2), row[k].at(3)};
      program.add_entry(row[k].at(0).get<int>(), values);
    }
  }
  return zoo;
}

}  // namespace

std::vector<ZooProgram> motion_programs() {
  const auto path = std::filesystem::path(TEST_DATA) / "motion" / "programs.json";
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  std::vector<ZooProgram> programs;
  for (const auto& data : nlohmann::json::parse(file))
    programs.push_back(program_of(data));
  return programs;
}

}  // namespace wuerfel::test
