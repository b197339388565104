#include "app/film/recording.h"

#include <cstddef>
#include <utility>

namespace wuerfel {

namespace {

using Scenery = Revisions::Scenery;

void put(const Vec2& v, Scenery& numbers) { numbers.insert(numbers.end(), {v.x(), v.y()}); }

Scenery encode(const Snapshot& snapshot) {
  Scenery numbers;
  for (const SnapshotBox& box : snapshot.boxes) {
    put(box.center, numbers);
    put(box.velocity, numbers);
    numbers.insert(numbers.end(), {box.angle, box.spin});
  }
  const auto put_count = [&numbers](const auto& list) {
    numbers.push_back(static_cast<double>(list.size()));
  };
  put_count(snapshot.forces);
  for (const SnapshotForce& force : snapshot.forces) {
    put(force.point, numbers);
    put(force.force, numbers);
    numbers.insert(numbers.end(),
                   {static_cast<double>(force.kind), static_cast<double>(force.body)});
  }
  put_count(snapshot.rods);
  for (const SnapshotRod& rod : snapshot.rods) {
    put(rod.a, numbers);
    put(rod.b, numbers);
    numbers.push_back(rod.tension);
  }
  put_count(snapshot.points);
  for (const SnapshotPoint& point : snapshot.points) {
    put(point.position, numbers);
    numbers.push_back(point.mass);
  }
  put_count(snapshot.contacts);
  for (const SnapshotContact& contact : snapshot.contacts) {
    for (const Vec2* v : {&contact.p_i, &contact.p_j, &contact.p_k, &contact.normal})
      put(*v, numbers);
  }
  put_count(snapshot.sides);
  for (const SnapshotSide& side : snapshot.sides) {
    for (const Vec2* v : {&side.p_i, &side.p_j, &side.p_k})
      put(*v, numbers);
    numbers.push_back(side.area);
  }
  return numbers;
}

// The numbers one by one, in the order in which `encode` wrote them.
class Cursor {
 public:
  explicit Cursor(const Scenery& numbers) : at_(numbers.data()) {}
  double number() { return *at_++; }
  Vec2 vector() {
    const double x = number();
    return {x, number()};
  }
  std::size_t count() { return static_cast<std::size_t>(number()); }

 private:
  const double* at_;
};

void decode(const Scenery& numbers, Snapshot& snapshot) {
  Cursor cursor(numbers);
  for (SnapshotBox& box : snapshot.boxes) {
    box.center = cursor.vector();
    box.velocity = cursor.vector();
    box.angle = cursor.number();
    box.spin = cursor.number();
  }
  snapshot.forces.resize(cursor.count());
  for (SnapshotForce& force : snapshot.forces) {
    force.point = cursor.vector();
    force.force = cursor.vector();
    force.kind = static_cast<ForceKind>(cursor.number());
    force.body = static_cast<int>(cursor.number());
  }
  snapshot.rods.resize(cursor.count());
  for (SnapshotRod& rod : snapshot.rods) {
    rod.a = cursor.vector();
    rod.b = cursor.vector();
    rod.tension = cursor.number();
  }
  snapshot.points.resize(cursor.count());
  for (SnapshotPoint& point : snapshot.points) {
    point.position = cursor.vector();
    point.mass = cursor.number();
  }
  snapshot.contacts.resize(cursor.count());
  for (SnapshotContact& contact : snapshot.contacts) {
    for (Vec2* v : {&contact.p_i, &contact.p_j, &contact.p_k, &contact.normal})
      *v = cursor.vector();
  }
  snapshot.sides.resize(cursor.count());
  for (SnapshotSide& side : snapshot.sides) {
    for (Vec2* v : {&side.p_i, &side.p_j, &side.p_k})
      *v = cursor.vector();
    side.area = cursor.number();
  }
}

// What stands before the numbers of a frame.
struct FrameHead {
  double time = 0.0;
  double energy = 0.0;
  std::uint64_t revision = 0;
  std::uint64_t numbers = 0;  // that follow; none where they are those of the frame before
};

}  // namespace

bool Revisions::stamp(Snapshot& snapshot) {
  Scenery scenery = encode(snapshot);
  const bool is_new = revision_ == 0 || scenery != scenery_;
  if (is_new) {
    scenery_ = std::move(scenery);
    ++revision_;
  }
  snapshot.revision = revision_;
  return is_new;
}

void Recording::add(Snapshot snapshot) {
  const bool is_new = revisions_.stamp(snapshot);
  const Scenery& scenery = revisions_.scenery();
  const FrameHead head{snapshot.time, snapshot.energy, snapshot.revision,
                       is_new ? scenery.size() : 0};
  log_.append({reinterpret_cast<const std::uint8_t*>(&head), sizeof head});
  if (is_new) {
    log_.append(
        {reinterpret_cast<const std::uint8_t*>(scenery.data()), scenery.size() * sizeof(double)});
  }
  if (size_ == 0) first_ = std::move(snapshot);
  ++size_;
}

bool Recording::Replay::next(Snapshot& snapshot) {
  if (done_ == recording_.size_) return false;
  if (done_ == 0) snapshot = recording_.first_;
  FrameHead head;
  recording_.log_.read(at_, {reinterpret_cast<std::uint8_t*>(&head), sizeof head});
  at_ += sizeof head;
  snapshot.time = head.time;
  snapshot.energy = head.energy;
  snapshot.revision = head.revision;
  if (head.numbers > 0) {
    Scenery numbers(head.numbers);
    const std::size_t bytes = numbers.size() * sizeof(double);
    recording_.log_.read(at_, {reinterpret_cast<std::uint8_t*>(numbers.data()), bytes});
    at_ += bytes;
    decode(numbers, snapshot);
  }
  ++done_;
  return true;
}

}  // namespace wuerfel
