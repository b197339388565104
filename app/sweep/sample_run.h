/// The motion of a sample: simulated once, looked at by all who want something of it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/stop_signal.h"
#include "app/sweep/columns.h"
#include "app/sweep/sample_film.h"
#include "app/sweep/sample_pictures.h"
#include "app/sweep/sweep_file.h"
#include "app/sweep/tape.h"
#include "core/scene/scene.h"
#include "core/time/simulation.h"

namespace wuerfel {

class SampleRun {
 public:
  SampleRun(const Sweep& sweep, const Scene& scene, const StopSignal& stop);

  /// Needed before `go` where pictures are wanted.
  void draw_with(Renderer& renderer) { renderer_ = &renderer; }
  /// Needed before `go` where a mask of violations is wanted: a number per cube.
  void mark(std::vector<std::uint16_t> violations) { violations_ = std::move(violations); }
  /// Simulates as far as anybody wants to know. Throws SampleError where that is not as exact as
  /// the tolerance promises.
  void go();
  [[nodiscard]] LabelRow labels() const;
  /// Named by their suffix: ".first.png".
  [[nodiscard]] std::vector<TapeFile> files();

 private:
  /// Who looks at an instant.
  struct Look {
    bool labels = false;
    bool states = false;
    bool film = false;
  };

  [[nodiscard]] std::map<double, Look> looks() const;
  void draw_first(const Simulation& simulation);
  void look(const Simulation& simulation, double t, const Look& look);
  void watch_fall(double t, const State& state);
  void finish(const Simulation& simulation);
  [[nodiscard]] Label label(RunColumn column) const;

  const Sweep& sweep_;
  const Scene& scene_;
  const StopSignal& stop_;
  SnapshotRequest request_;
  Renderer* renderer_ = nullptr;
  std::vector<std::uint16_t> violations_;
  std::optional<SamplePictures> pictures_;
  std::unique_ptr<SampleFilm> film_;
  std::vector<TapeFile> files_;
  std::vector<double> states_;  // rows of t, cubes, six numbers
  std::size_t state_rows_ = 0;
  std::optional<double> time_of_fall_;  // s
  State end_;
  std::vector<Event> events_;
  std::int64_t moved_ = 0;
  bool at_rest_ = false;
};

}  // namespace wuerfel
