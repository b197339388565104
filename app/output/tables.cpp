#include "app/output/tables.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/output/summary.h"

namespace wuerfel {

namespace {

std::string_view kind_name(ForceKind kind) {
  switch (kind) {
    case ForceKind::contact:
      return "contact";
    case ForceKind::friction:
      return "friction";
    case ForceKind::rod_tension:
      return "rod_tension";
    case ForceKind::rod_compression:
      return "rod_compression";
  }
  return "?";
}

// Names of bodies may contain what CSV uses itself.
std::string quoted(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
  std::string text = "\"";
  for (const char c : name)
    text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

std::string pushed(const Snapshot& snapshot, const SnapshotForce& force) {
  return force.body < 0 ? std::string() : quoted(snapshot.boxes[force.body].name);
}

}  // namespace

Tables::Tables(const std::string& states, const std::string& forces, const std::string& events) {
  if (!states.empty()) states_.emplace(states).write("t,body,x,y,theta,vx,vy,omega\n");
  if (!forces.empty()) forces_.emplace(forces).write("t,on,kind,x,y,fx,fy,kkt_residual\n");
  if (!events.empty()) events_.emplace(events);
}

// "{}" writes as many digits as bring the same number back.
void Tables::add_states(double t, const Scene& scene, const State& states) {
  if (!states_) return;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BodyState& s = states[i];
    states_->write(fmt::format("{},{},{},{},{},{},{},{}\n", t,
                               quoted(moving_name(scene, static_cast<int>(i))), s.position.x(),
                               s.position.y(), s.angle, s.velocity.x(), s.velocity.y(), s.spin));
  }
}

void Tables::add_forces(const Snapshot& snapshot) {
  if (!forces_) return;
  for (const SnapshotForce& force : snapshot.forces) {
    forces_->write(fmt::format("{},{},{},{},{},{},{},{}\n", snapshot.time, pushed(snapshot, force),
                               kind_name(force.kind), force.point.x(), force.point.y(),
                               force.force.x(), force.force.y(), snapshot.force_residual));
  }
  add_links(snapshot);
}

void Tables::add_links(const Snapshot& snapshot) {
  for (const SnapshotLink& link : snapshot.links) {
    const std::string_view kind = link.pin             ? "pin"
                                  : link.tension < 0.0 ? kind_name(ForceKind::rod_compression)
                                                       : kind_name(ForceKind::rod_tension);
    const auto write = [&](const std::string& body, const Vec2& place, const Vec2& force) {
      if (body.empty()) return;
      forces_->write(fmt::format("{},{},{},{},{},{},{},{}\n", snapshot.time, quoted(body), kind,
                                 place.x(), place.y(), force.x(), force.y(),
                                 snapshot.force_residual));
    };
    write(link.bodies[0], link.a, link.force);
    write(link.bodies[1], link.b, -link.force);
  }
}

void Tables::finish(const std::vector<Event>& events) {
  if (events_) {
    for (const Event& event : events)
      events_->write(event_json(event).dump() + "\n");
  }
  for (auto* file : {&states_, &forces_, &events_}) {
    if (*file) (*file)->finish();
  }
}

}  // namespace wuerfel
