#include "app/output/program_file.h"

#include <map>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/exit_code.h"
#include "core/qp/coulomb/coulomb_solver.h"
#include "core/qp/qp_solver.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_unknowns = 10'000'000;

/// [row, column, value] of the rows of one kind, counted among themselves, and their bounds.
struct Rows {
  Json triplets = Json::array();
  Json bounds = Json::array();
};

Rows rows_of(const QuadraticProgram& program, bool equalities) {
  Rows rows;
  for (int i = 0; i < program.rows(); ++i) {
    if (program.is_equality(i) != equalities) continue;
    program.for_each_entry(i, [&](const double* J, int first, int size) {
      for (int c = 0; c < size; ++c)
        if (J[c] != 0.0) rows.triplets.push_back({rows.bounds.size(), first + c, J[c]});
    });
    rows.bounds.push_back(program.bound[i]);
  }
  return rows;
}

/// A number of one of `count` things; a double, beyond all of them too, is none.
int number_of(const Json& json, std::size_t count, const char* thing) {
  const bool whole = json.is_number_integer();
  if (!whole || json < 0 || json >= count)
    throw UsageError(fmt::format("there is no {} {}", thing, json.dump()));
  return json.get<int>();
}

void add_rows(const Json& triplets,
              const std::vector<double>& bounds,
              bool equalities,
              QuadraticProgram& program) {
  std::map<int, std::map<int, std::vector<double>>> blocks;  // row -> block -> coefficients
  for (const Json& triplet : triplets) {
    const int row = number_of(triplet.at(0), bounds.size(), "row");
    const int column = number_of(triplet.at(1), program.mass.size(), "unknown");
    auto& block = blocks[row][column / program.block_size];
    block.resize(program.block_size, 0.0);
    block[column % program.block_size] = triplet.at(2).get<double>();
  }
  for (int i = 0; i < static_cast<int>(bounds.size()); ++i) {
    equalities ? program.add_equality(bounds[i]) : program.add_inequality(bounds[i]);
    for (const auto& [block, coefficients] : blocks[i])
      program.add_entry(block, coefficients);
  }
}

/// [normal row of J, tangential row of E or -1, mu, direction of slip]
Json contacts_of(const FrictionProgram& friction) {
  std::vector<int> number;  // of each row among those of its kind
  int equalities = 0;
  for (int i = 0; i < friction.program.rows(); ++i) {
    const bool equality = friction.program.is_equality(i);
    number.push_back(equality ? equalities : i - equalities);
    if (equality) ++equalities;
  }
  Json contacts = Json::array();
  for (const FrictionContact& c : friction.contacts) {
    const int tangent = c.tangent < 0 ? -1 : number[c.tangent];
    contacts.push_back({number[c.normal], tangent, c.mu, c.slides});
  }
  return contacts;
}

/// `equalities` come before the inequalities.
FrictionContact contact_of(const Json& json, std::size_t equalities, std::size_t inequalities) {
  FrictionContact contact;
  contact.normal = static_cast<int>(equalities) + number_of(json.at(0), inequalities, "row of J");
  if (json.at(1) != -1) contact.tangent = number_of(json.at(1), equalities, "row of E");
  contact.mu = json.at(2).get<double>();
  if (json.at(3) != 0) contact.slides = json.at(3) > 0 ? 1 : -1;
  return contact;
}

KeptProgram program_of(const Json& json) {
  KeptProgram kept;
  QuadraticProgram& program = kept.program;
  constexpr std::size_t largest_block = 3;
  const int block_size = number_of(json.at("block_size"), largest_block + 1, "block_size");
  if (block_size == 0) throw UsageError("block_size is 1, 2 or 3");
  program.clear(block_size);
  program.mass = json.at("M_diag").get<std::vector<double>>();
  program.target = json.at("F").get<std::vector<double>>();
  if (program.mass.size() > most_unknowns) throw UsageError("too many unknowns");
  add_rows(json.at("E_triplets"), json.at("d").get<std::vector<double>>(), true, program);
  add_rows(json.at("J_triplets"), json.at("b").get<std::vector<double>>(), false, program);
  if (json.contains("contacts")) {
    const std::size_t equalities = json.at("d").size();
    for (const Json& contact : json.at("contacts"))
      kept.contacts.push_back(contact_of(contact, equalities, json.at("b").size()));
  }
  const bool rubs = !kept.contacts.empty();
  if (const std::string_view wrong = rubs ? defect(kept.view()) : defect(program); !wrong.empty())
    throw UsageError(std::string(wrong));
  return kept;
}

}  // namespace

std::string program_text(const FrictionProgram& friction) {
  const QuadraticProgram& program = friction.program;
  Rows equalities = rows_of(program, true);
  Rows inequalities = rows_of(program, false);
  Json json{{"block_size", program.block_size},
            {"M_diag", program.mass},
            {"F", program.target},
            {"J_triplets", std::move(inequalities.triplets)},
            {"b", std::move(inequalities.bounds)},
            {"E_triplets", std::move(equalities.triplets)},
            {"d", std::move(equalities.bounds)}};
  if (!friction.contacts.empty()) json["contacts"] = contacts_of(friction);
  return json.dump() + "\n";
}

KeptProgram parse_program(std::string_view text, const std::string& place) try {
  return program_of(Json::parse(text));
} catch (const Json::parse_error& error) {
  throw UsageError(fmt::format("{}: no program: no JSON from byte {} on", place, error.byte));
} catch (const Json::exception& error) {
  throw UsageError(fmt::format("{}: no program: {}", place, error.what()));
} catch (const UsageError& error) {
  throw UsageError(fmt::format("{}: no program: {}", place, error.what()));
}

void ProgramFile::add(const FrictionProgram& program) {
  if (programs_++ < most_programs) file_.write(program_text(program));
}

}  // namespace wuerfel
