#include "app/output/summary.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/scene_source.h"
#include "core/scene/scene_parser.h"

namespace wuerfel {

namespace {

using Json = nlohmann::ordered_json;

Json settings_json(const MotionSettings& settings) {
  return {{"integrator", to_string(settings.integrator)},
          {"formulation", to_string(settings.formulation)},
          {"solver", to_string(settings.solver)},
          {"tolerance", settings.tolerance},
          {"step", settings.step}};
}

Json sample_json(const Scene& scene, const StateSample& sample) {
  Json bodies = Json::object();
  for (std::size_t i = 0; i < sample.states.size(); ++i) {
    const BodyState& body = sample.states[i];
    bodies[moving_name(scene, static_cast<int>(i))] = {
        {"x", body.position.x()},  {"y", body.position.y()},  {"theta", body.angle},
        {"vx", body.velocity.x()}, {"vy", body.velocity.y()}, {"omega", body.spin}};
  }
  return {{"t", sample.t}, {"bodies", std::move(bodies)}};
}

Json audit_json(const Simulation& simulation) {
  const Audit audit = simulation.audit();
  return {{"max_penetration", audit.max_penetration},
          {"max_rod_error", audit.max_rod_error},
          {"rods_contradicting", audit.rods_contradicting},
          {"max_kkt_residual", audit.max_kkt_residual},
          {"unresolved", audit.unresolved},
          {"searches_given_up", audit.searches_given_up},
          {"wedged", audit.wedged},
          {"friction_inexact", audit.friction_inexact},
          {"friction_residual", audit.friction_residual},
          {"restitution_reduced", audit.restitution_reduced},
          {"momentum", {{"linear", audit.momentum_linear}, {"angular", audit.momentum_angular}}},
          {"momentum_settled", audit.momentum_settled},
          {"energy",
           {{"start", audit.energy_start},
            {"end", audit.energy_end},
            {"impact_loss", audit.impact_loss},
            {"friction_loss", audit.friction_loss},
            {"drift", audit.drift()}}},
          {"state_hash", fmt::format("{:016x}", simulation.state_hash())}};
}

Json cost_json(const Cost& work, const RunCost& cost) {
  return {{"wall_s", cost.wall_s},
          {"cpu_s", cost.cpu_s},
          {"start_s", cost.start_s},
          {"steps", work.steps},
          {"qp_solves", work.qp_solves},
          {"qp_skipped", work.qp_skipped()},
          {"hand_overs", work.hand_overs},
          {"frames", cost.frames},
          {"frames_reused", cost.frames_reused},
          {"skipped",
           {{"free", work.skipped_free},
            {"rest", work.skipped_rest},
            {"certificate", work.skipped_certificate}}}};
}

}  // namespace

SummaryFile::SummaryFile(const std::string& name) {
  if (!name.empty()) file_.emplace(name);
}

void SummaryFile::write(const std::string& text) {
  if (!file_) return;
  file_->write(text);
  file_->finish();
}

Json event_json(const Event& event) {
  return {{"t", event.t},
          {"kind", to_string(event.kind)},
          {"bodies", {event.on, event.from}},
          {"point", {event.point.x(), event.point.y()}},
          {"impulse", event.impulse}};
}

Json violation_json(const Violation& violation) {
  return {{"what", violation.promise}, {"t", violation.t}, {"bodies", violation.bodies}};
}

Json run_summary(const Scene& scene,
                 const MotionSettings& settings,
                 const Simulation& simulation,
                 const std::vector<StateSample>& samples,
                 const Notes& notes,
                 const RunCost& cost) {
  Json sample_list = Json::array();
  for (const StateSample& sample : samples)
    sample_list.push_back(sample_json(scene, sample));
  Json event_list = Json::array();
  for (const Event& event : simulation.events())
    event_list.push_back(event_json(event));
  return {{"version", WUERFEL_VERSION},
          {"scene", {{"title", scene.title}, {"hash", text_hash(normalised_scene(scene))}}},
          {"settings", settings_json(settings)},
          {"t_end", simulation.time()},
          {"samples", std::move(sample_list)},
          {"events", std::move(event_list)},
          {"audit", audit_json(simulation)},
          {"notes", notes.texts()},
          {"outcome", {{"moved", simulation.moved()}, {"at_rest", simulation.at_rest()}}},
          {"cost", cost_json(simulation.cost(), cost)}};
}

}  // namespace wuerfel
