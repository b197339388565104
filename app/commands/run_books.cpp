#include "app/commands/run_books.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace wuerfel {

RunOutputs::RunOutputs(const RunOptions& asked, const AnimationSettings& animation)
    : pictures(asked.outputs, animation, asked.hold),
      tables(asked.states, asked.forces, asked.events) {}

RunBooks::RunBooks(const RunOptions& asked, const MotionSource& source, RunOutputs& outputs)
    : asked_(asked),
      scene_(source.scene),
      pictures_(outputs.pictures),
      tables_(outputs.tables),
      taker_(source.request, source.passing, source.back),
      film_(asked.picture, asked.rate, source, pictures_) {}

void RunBooks::take(const TimetableEntry& instant,
                    const Simulation& simulation,
                    const Moment& moment) {
  if (instant.sample) samples_.push_back({instant.t, moment.state});
  if (instant.frame) tables_.add_states(instant.t, scene_, moment.state);
  if (asked_.forces.empty() && pictures_.empty()) return;
  std::optional<Snapshot> snapshot = taker_.take(simulation, moment, instant);
  if (!snapshot) return;
  tables_.add_forces(*snapshot);
  if (!asked_.forces.empty()) worst_force_ = std::max(worst_force_, snapshot->force_residual);
  // What only a table asked for is not seen.
  if (!asked_.picture.layers.has(Layer::contact_forces)) snapshot->forces.clear();
  if (!pictures_.empty()) film_.add(std::move(*snapshot));
}

void RunBooks::finish(const Simulation& simulation, Progress::Style style) {
  film_.finish(style);
  tables_.finish(simulation.events());
}

CheckpointKeeper::CheckpointKeeper(const RunOptions& asked, std::string origin, Checkpoint resumed)
    : path_(asked.checkpoint), origin_(std::move(origin)), kept_(std::move(resumed)) {}

void CheckpointKeeper::listen(Simulation& simulation) {
  if (path_.empty()) return;
  simulation.set_restart_listener([this](std::string restart_point) {
    kept_.restart_point = std::move(restart_point);
    std::ranges::move(since_, std::back_inserter(kept_.moments));
    since_.clear();
    written_ = false;
  });
}

void CheckpointKeeper::add(const Moment& moment) {
  if (!path_.empty()) since_.push_back(moment);
}

void CheckpointKeeper::write(const AccuracyWatch& accuracy) {
  if (path_.empty() || written_) return;
  kept_.first_violation = accuracy.first();
  write_checkpoint(path_, origin_, kept_);
  written_ = true;
}

}  // namespace wuerfel
