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

/// Of a box, or of a plane behind them; points are not known.
std::string name_of(const Snapshot& snapshot, int body) {
  const int boxes = static_cast<int>(snapshot.boxes.size());
  if (body < 0) return {};
  return csv_cell(body < boxes ? snapshot.boxes[body].name : snapshot.planes[body - boxes].name);
}

/// A row of the table of forces. Adding 0 turns -0 into 0.
std::string force_row(const Snapshot& snapshot,
                      std::string_view on,
                      std::string_view from,
                      std::string_view kind,
                      const Vec2& place,
                      const Vec2& force) {
  return fmt::format("{},{},{},{},{},{},{},{},{}\n", snapshot.time, on, from, kind, place.x(),
                     place.y(), force.x() + 0.0, force.y() + 0.0, snapshot.force_residual);
}

}  // namespace

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

Tables::Tables(const std::string& states, const std::string& forces, const std::string& events) {
  if (!states.empty()) states_.emplace(states).write("t,body,x,y,theta,vx,vy,omega\n");
  if (!forces.empty()) forces_.emplace(forces).write("t,on,from,kind,x,y,fx,fy,kkt_residual\n");
  if (!events.empty()) events_.emplace(events);
}

// "{}" writes as many digits as bring the same number back.
void Tables::add_states(double t, const Scene& scene, const State& states) {
  if (!states_) return;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BodyState& s = states[i];
    states_->write(fmt::format("{},{},{},{},{},{},{},{}\n", t,
                               csv_cell(moving_name(scene, static_cast<int>(i))), s.position.x(),
                               s.position.y(), s.angle, s.velocity.x(), s.velocity.y(), s.spin));
  }
}

void Tables::add_forces(const Snapshot& snapshot) {
  if (!forces_) return;
  for (const SnapshotForce& force : snapshot.forces) {
    forces_->write(force_row(snapshot, name_of(snapshot, force.body),
                             name_of(snapshot, force.other), kind_name(force.kind), force.point,
                             force.force));
  }
  add_links(snapshot);
}

void Tables::add_links(const Snapshot& snapshot) {
  for (const SnapshotLink& link : snapshot.links) {
    const std::string_view kind = link.pin             ? "pin"
                                  : link.tension < 0.0 ? kind_name(ForceKind::rod_compression)
                                                       : kind_name(ForceKind::rod_tension);
    const auto write = [&](int end, const Vec2& place, const Vec2& force) {
      const std::string& on = link.bodies.at(end);
      if (on.empty()) return;
      const std::string from = csv_cell(link.bodies.at(1 - end));
      forces_->write(force_row(snapshot, csv_cell(on), from, kind, place, force));
    };
    write(0, link.a, link.force);
    write(1, link.b, -link.force);
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
