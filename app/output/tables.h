/// Tables of a run: one row per body or force at every frame time, as CSV; events as lines of JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/output/text_output.h"
#include "core/scene/scene.h"
#include "core/snapshot.h"
#include "core/time/simulation.h"

namespace wuerfel {

/// A text as a cell of a table: what CSV uses itself is quoted [RFC 4180].
std::string csv_cell(const std::string& text);

/// The tables that were asked for: file names, empty where not wanted.
class Tables {
 public:
  /// Throws OutputError at once where one of them cannot be written.
  Tables(const std::string& states, const std::string& forces, const std::string& events);

  void add_states(double t, const Scene& scene, const State& states);
  void add_forces(const Snapshot& snapshot);
  /// Writes the events and gives all files their names.
  void finish(const std::vector<Event>& events);

 private:
  void add_links(const Snapshot& snapshot);

  std::optional<TextOutput> states_;
  std::optional<TextOutput> forces_;
  std::optional<TextOutput> events_;
};

}  // namespace wuerfel
