/// The reference cases: scenes with exact answers, as data. Format: tests/data/README.md.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/scene/scene.h"

namespace wuerfel::test {

struct ReferenceCase {
  std::string name;
  std::string kind;
  Scene scene;
  nlohmann::json data;  ///< the whole file; "expected" holds the answers

  /// Number of a cube by its id. Throws std::out_of_range.
  [[nodiscard]] int cube(const std::string& id) const;
  /// Total weight, N.
  [[nodiscard]] double weight() const;
};

/// `stem` is the name of the file without folder and ending. Throws std::runtime_error if it cannot
/// be read.
ReferenceCase read_reference_case(const std::string& stem);

/// Names of all cases of a kind whose name starts with one of the prefixes (none: all), in order.
/// Cases that need friction or restitution are left out, but where all of that kind do (`friction`).
std::vector<std::string> reference_case_names(const std::string& kind,
                                              const std::vector<std::string>& prefixes = {});

/// The stem as a test's name: letters, digits and underscores only.
std::string test_name(std::string stem);

}  // namespace wuerfel::test
