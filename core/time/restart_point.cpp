#include "core/time/restart_point.h"

#include "core/time/archive.h"

namespace wuerfel {

// Found by the types of their arguments, hence in the namespace of these.

template <class Archive>
void transfer(Archive& archive, Event& e) {
  archive(e.t);
  archive(e.kind);
  archive(e.on);
  archive(e.from);
  transfer(archive, e.point);
  archive(e.impulse);
}

template <class Archive>
void transfer(Archive& archive, Loss& loss) {
  archive(loss.t);
  archive(loss.energy);
  archive(loss.friction);
  archive(loss.since);
}

template <class Archive>
void transfer(Archive& archive, Push& push) {
  transfer(archive, push.linear);
  archive(push.angular);
}

template <class Archive>
void transfer(Archive& archive, Stepping& stepping) {
  archive(stepping.until);
  archive(stepping.patience);
}

template <class Archive>
void transfer(Archive& archive, Audit& a) {
  for (double* number : {&a.max_penetration, &a.max_overlap, &a.max_rod_error, &a.max_kkt_residual,
                         &a.friction_residual, &a.impact_loss, &a.friction_loss, &a.momentum_linear,
                         &a.momentum_angular, &a.momentum_settled})
    archive(*number);
  for (long* number : {&a.missed_solves, &a.unresolved, &a.searches_given_up, &a.wedged,
                       &a.friction_inexact, &a.restitution_reduced, &a.rods_contradicting})
    archive(*number);
}

template <class Archive>
void transfer(Archive& archive, Cost& c) {
  for (long* number : {&c.steps, &c.qp_solves, &c.qp_iterations, &c.hand_overs, &c.skipped_free,
                       &c.skipped_rest, &c.skipped_certificate})
    archive(*number);
}

template <class Archive>
void transfer(Archive& archive, Breach& breach) {
  archive(breach.promise);
  archive(breach.t);
  transfer_list(archive, breach.bodies);
}

template <class Archive>
void transfer(Archive& archive, Bookkeeping& book) {
  transfer_list(archive, book.events);
  transfer_list(archive, book.losses);
  transfer(archive, book.audit);
  transfer(archive, book.cost);
  transfer_list(archive, book.breaches);
  transfer(archive, book.settled);
  transfer(archive, book.unexplained);
}

template <class Archive>
void transfer(Archive& archive, RestartPoint& p) {
  archive(p.t);
  transfer_list(archive, p.state);
  transfer(archive, p.book);
  std::uint64_t hash = p.hash.value();
  archive(hash);
  p.hash.set(hash);
  archive(p.momentum.linear);
  archive(p.momentum.angular);
  archive(p.window);
  transfer_list(archive, p.resting);
  transfer_list(archive, p.stepping);
  archive(p.steps);
}

template <class Archive>
void transfer(Archive& archive, Contact& c) {
  for (int* number : {&c.on, &c.from, &c.corner, &c.side})
    archive(*number);
  for (double* number : {&c.gap, &c.slip, &c.alpha, &c.length})
    archive(*number);
  for (Vec2* v : {&c.point, &c.normal, &c.arm_k, &c.arm_i, &c.arm_j})
    transfer(archive, *v);
}

/// Contacts alone.
struct Contacts {
  std::vector<Contact> list;
};

template <class Archive>
void transfer(Archive& archive, Contacts& contacts) {
  transfer_list(archive, contacts.list);
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

std::string to_bytes(const std::vector<Contact>& contacts) { return bytes_of(Contacts{contacts}); }

std::vector<Contact> contacts_of(std::string_view bytes, int bodies) {
  auto contacts = value_of<Contacts>(bytes).list;
  const auto is_body = [bodies](int body) { return body >= 0 && body < bodies; };
  for (const Contact& c : contacts) {
    if (!is_body(c.on) || !is_body(c.from)) throw RestartError("it is of other bodies");
  }
  return contacts;
}

}  // namespace wuerfel
