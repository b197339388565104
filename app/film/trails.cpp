#include "app/film/trails.h"

namespace wuerfel {

namespace {

constexpr std::size_t most_places = 2048;

}  // namespace

void Trails::add(const Snapshot& snapshot) {
  if (last_is_extra_) {
    for (SnapshotTrail& trail : paths_)
      trail.path.pop_back();
  }
  std::size_t i = 0;
  for (const SnapshotBox& box : snapshot.boxes) {
    if (box.fixed) continue;
    if (i == paths_.size()) paths_.push_back({box.color_index, box.color, {}});
    paths_[i++].path.push_back(box.center);
  }
  for (const SnapshotMass& mass : snapshot.masses) {
    if (i == paths_.size()) paths_.push_back({static_cast<int>(i), {}, {}});
    paths_[i++].path.push_back(mass.position);
  }
  last_is_extra_ = moments_ % stride_ != 0;
  ++moments_;
  if (!paths_.empty() && !last_is_extra_ && paths_.front().path.size() >= most_places) thin_out();
}

void Trails::thin_out() {
  for (SnapshotTrail& trail : paths_) {
    std::size_t kept = 0;
    for (std::size_t from = 0; from < trail.path.size(); from += 2)
      trail.path[kept++] = trail.path[from];
    // The last place stays whether its turn has come or not.
    if (trail.path.size() % 2 == 0) trail.path[kept++] = trail.path.back();
    trail.path.resize(kept);
  }
  stride_ *= 2;
  last_is_extra_ = (moments_ - 1) % stride_ != 0;
}

}  // namespace wuerfel
