#include "app/sweep/sample_run.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/cli/pace.h"
#include "app/cli/streams.h"
#include "app/film/timetable.h"
#include "app/output/accuracy.h"
#include "app/sweep/npy.h"
#include "app/sweep/sample.h"
#include "core/geometry/trig.h"

namespace wuerfel {

namespace {

constexpr double fall_rate = 60.0;  // looks per second for the time of fall
constexpr double fall_share = 0.1;  // of the smaller side: further away a cube has fallen
constexpr std::size_t numbers = 6;  // of a cube in a row of states

double highest_corner(const Scene& scene, const State& state) {
  double top = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.cubes.size(); ++i) {
    double sine = 0.0;
    double cosine = 1.0;
    sin_cos(state[i].angle, sine, cosine);
    const Vec2 half = 0.5 * scene.cubes[i].size;
    top = std::max(top,
                   state[i].position.y() + half.x() * std::abs(sine) + half.y() * std::abs(cosine));
  }
  for (std::size_t i = scene.cubes.size(); i < state.size(); ++i)
    top = std::max(top, state[i].position.y());
  return top;
}

}  // namespace

SampleRun::SampleRun(const Sweep& sweep, const Scene& scene, const StopSignal& stop)
    : sweep_(sweep),
      scene_(scene),
      stop_(stop),
      request_(snapshot_request(picture_options(sweep.files), scene.cubes.size())) {}

std::map<double, SampleRun::Look> SampleRun::looks() const {
  const double end = sweep_.labels.until.value_or(scene_.duration);
  std::map<double, Look> looks;
  const auto add = [&](double rate, bool Look::*who) {
    for (const double t : frame_times(end, {rate, 1.0}))
      looks[t].*who = true;
  };
  if (!sweep_.labels.run.empty()) {
    add(fall_rate, &Look::labels);
    looks[end].labels = true;
  }
  if (sweep_.files.states) add(*sweep_.files.states, &Look::states);
  if (sweep_.files.video) add(*sweep_.files.video, &Look::film);
  return looks;
}

void SampleRun::draw_first(const Simulation& simulation) {
  const Snapshot first = simulation.snapshot(request_);
  pictures_.emplace(scene_, sweep_.files, first, stop_, *renderer_);
  if (sweep_.files.first_frame) files_.push_back({".first.png", pictures_->frame(first)});
  if (sweep_.files.instance_mask) files_.push_back({".instance.png", pictures_->instances(first)});
  if (sweep_.files.violation_mask)
    files_.push_back({".violation.png", pictures_->numbered(first, violations_)});
  if (sweep_.files.video) film_ = std::make_unique<SampleFilm>(sweep_.files, stop_);
}

void SampleRun::go() {
  const std::map<double, Look> all = looks();
  if (all.empty() && !sweep_.files.pictures()) return;
  Simulation simulation(scene_, {});
  const double end = all.empty() ? 0.0 : all.rbegin()->first;
  watch_steps(simulation, scene_, Integrator::automatic, end, stop_);
  if (sweep_.files.pictures()) draw_first(simulation);
  for (const auto& [t, who] : all) {
    simulation.advance_to(t);
    look(simulation, t, who);
  }
  if (!all.empty()) finish(simulation);
}

void SampleRun::look(const Simulation& simulation, double t, const Look& look) {
  if (look.labels && !time_of_fall_) watch_fall(t, simulation.states());
  if (look.film) film_->add(pictures_->pixels(simulation.snapshot(request_)));
  if (!look.states) return;
  for (const BodyState& body : simulation.states()) {
    states_.insert(states_.end(), {body.position.x(), body.position.y(), body.angle,
                                   body.velocity.x(), body.velocity.y(), body.spin});
  }
  ++state_rows_;
}

void SampleRun::watch_fall(double t, const State& state) {
  for (std::size_t i = 0; i < scene_.cubes.size(); ++i) {
    const SceneCube& cube = scene_.cubes[i];
    if ((state[i].position - cube.position).norm() > fall_share * cube.size.minCoeff())
      time_of_fall_ = t;
  }
}

void SampleRun::finish(const Simulation& simulation) {
  Notes notes(Notes::Voice::later);
  AccuracyWatch accuracy;
  accuracy.look(simulation, 0.0);
  if (accuracy.verdict(notes) != ExitCode::fine)
    throw SampleError(fmt::format("{}", fmt::join(notes.texts(), "; ")));
  end_ = simulation.states();
  events_ = simulation.events();
  moved_ = static_cast<std::int64_t>(simulation.moved().size());
  at_rest_ = simulation.at_rest();
  if (sweep_.files.states)
    files_.push_back({".states.npy", npy_of(states_, {state_rows_, end_.size(), numbers})});
  if (film_) files_.push_back({".mp4", film_->finish()});
}

std::vector<TapeFile> SampleRun::files() { return std::move(files_); }

LabelRow SampleRun::labels() const {
  LabelRow row;
  for (const RunColumn column : sweep_.labels.run)
    row.emplace_back(to_string(column), label(column));
  return row;
}

Label SampleRun::label(RunColumn column) const {
  switch (column) {
    case RunColumn::time_of_fall:
      return time_of_fall_ ? Label(*time_of_fall_) : Label();
    case RunColumn::moved:
      return moved_;
    case RunColumn::at_rest:
      return at_rest_;
    case RunColumn::final_height:
      return highest_corner(scene_, end_);
    case RunColumn::first_event:
      return events_.empty() ? Label() : Label(std::string(to_string(events_.front().kind)));
    case RunColumn::first_event_time:
      return events_.empty() ? Label() : Label(events_.front().t);
    case RunColumn::events:
      return static_cast<std::int64_t>(events_.size());
  }
  return {};
}

}  // namespace wuerfel
