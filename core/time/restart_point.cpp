#include "core/time/restart_point.h"

#include "core/time/archive.h"

namespace wuerfel {

// Found by the types of their arguments, hence in the namespace of these.

template <class Archive>
void transfer(Archive& archive, Event& e) {
  transfer_all(archive, e.t, e.kind, e.on, e.from, e.point, e.impulse);
}

template <class Archive>
void transfer(Archive& archive, Loss& loss) {
  transfer_all(archive, loss.t, loss.energy, loss.friction, loss.since);
}

template <class Archive>
void transfer(Archive& archive, Push& push) {
  transfer_all(archive, push.linear, push.angular);
}

template <class Archive>
void transfer(Archive& archive, Stepping& stepping) {
  transfer_all(archive, stepping.until, stepping.patience);
}

template <class Archive>
void transfer(Archive& archive, Audit& a) {
  transfer_all(archive, a.max_penetration, a.max_overlap, a.max_rod_error, a.max_kkt_residual,
               a.friction_residual, a.impact_loss, a.friction_loss, a.momentum_linear,
               a.momentum_angular, a.momentum_settled, a.missed_solves, a.unresolved,
               a.searches_given_up, a.wedged, a.friction_inexact, a.restitution_reduced,
               a.rods_contradicting);
}

template <class Archive>
void transfer(Archive& archive, Cost& c) {
  transfer_all(archive, c.steps, c.qp_solves, c.qp_iterations, c.hand_overs, c.skipped_free,
               c.skipped_rest, c.skipped_certificate);
}

template <class Archive>
void transfer(Archive& archive, Breach& breach) {
  transfer_all(archive, breach.promise, breach.t, breach.bodies);
}

template <class Archive>
void transfer(Archive& archive, Bookkeeping& book) {
  transfer_all(archive, book.events, book.losses, book.audit, book.cost, book.breaches,
               book.settled, book.unexplained);
}

template <class Archive>
void transfer(Archive& archive, RestartPoint& p) {
  std::uint64_t hash = p.hash.value();
  transfer_all(archive, p.t, p.state, p.book, hash, p.momentum.linear, p.momentum.angular, p.window,
               p.resting, p.stepping, p.steps);
  p.hash.set(hash);
}

template <class Archive>
void transfer(Archive& archive, Contact& c) {
  transfer_all(archive, c.on, c.from, c.corner, c.side, c.gap, c.slip, c.alpha, c.length, c.point,
               c.normal, c.arm_k, c.arm_i, c.arm_j);
}

namespace {

template <typename T>
std::string bytes_of(const T& value) {
  ArchiveWriter writer;
  T copy = value;
  transfer(writer, copy);
  return writer.bytes();
}

template <typename T>
T value_of(std::string_view bytes) {
  ArchiveReader reader(bytes);
  T value;
  transfer(reader, value);
  if (!reader.at_end()) throw RestartError("it is longer than it should be");
  return value;
}

}  // namespace

std::string to_bytes(const RestartPoint& point) { return bytes_of(point); }

RestartPoint restart_point_of(std::string_view bytes, std::size_t cubes) {
  auto point = value_of<RestartPoint>(bytes);
  const auto fits = [cubes](std::size_t size) { return size == 0 || size == cubes; };
  if (point.state.size() != cubes || !fits(point.resting.size()) || !fits(point.stepping.size()))
    throw RestartError("it is of another number of cubes");
  return point;
}

std::string to_bytes(const std::vector<Contact>& contacts) { return bytes_of(contacts); }

std::vector<Contact> contacts_of(std::string_view bytes, int bodies) {
  auto contacts = value_of<std::vector<Contact>>(bytes);
  const auto is_body = [bodies](int body) { return body >= 0 && body < bodies; };
  for (const Contact& c : contacts) {
    if (!is_body(c.on) || !is_body(c.from)) throw RestartError("it is of other bodies");
  }
  return contacts;
}

}  // namespace wuerfel
