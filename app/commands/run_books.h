/// What a run hands out, moment by moment, and keeps so that it can be taken up again.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/run_plan.h"
#include "app/film/film.h"
#include "app/film/frame_taker.h"
#include "app/output/checkpoint.h"
#include "app/output/summary.h"
#include "app/output/tables.h"

namespace wuerfel {

/// What a run writes while it goes on.
struct RunOutputs {
  /// Throws OutputError where something cannot be written or is missing: it is noticed before the long work.
  RunOutputs(const RunOptions& asked, const AnimationSettings& animation);

  PictureOutputs pictures;
  Tables tables;
};

/// Frames, tables and samples.
class RunBooks {
 public:
  /// Everything told lives longer than the books.
  RunBooks(const RunOptions& asked, const MotionSource& source, RunOutputs& outputs);

  /// A moment that somebody wants to see. Throws OutputError, RenderError, Interrupted.
  void take(const TimetableEntry& instant, const Simulation& simulation, const Moment& moment);
  /// Completes all of them. Throws the same.
  void finish(const Simulation& simulation, Progress::Style style);

  [[nodiscard]] const std::vector<StateSample>& samples() const { return samples_; }
  /// The worst residual of the forces in the tables.
  [[nodiscard]] double worst_force() const { return worst_force_; }
  [[nodiscard]] long frames() const { return film_.frames(); }
  [[nodiscard]] long reused() const { return film_.reused(); }
  [[nodiscard]] int labels_left_out() const { return film_.labels_left_out(); }

 private:
  const RunOptions& asked_;
  const Scene& scene_;
  PictureOutputs& pictures_;
  Tables& tables_;
  FrameTaker taker_;
  Film film_;
  std::vector<StateSample> samples_;
  double worst_force_ = 0.0;
};

/// Writes checkpoints of a run. Where none is asked for nothing is kept.
class CheckpointKeeper {
 public:
  CheckpointKeeper(const RunOptions& asked, std::string origin, Checkpoint resumed);

  /// From now on the restarts of the simulation are noted.
  void listen(Simulation& simulation);
  void add(const Moment& moment);
  /// Writes what was kept up to the last restart, where that was not written before. Throws
  /// OutputError.
  void write(const AccuracyWatch& accuracy);

 private:
  std::string path_;
  std::string origin_;
  Checkpoint kept_;            ///< up to the last restart
  std::vector<Moment> since_;  ///< moments after it
  bool written_ = false;
};

}  // namespace wuerfel
