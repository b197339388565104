#include "core/scene/placement.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/scene/frame.h"

namespace wuerfel {
namespace {

/// Follows each group's `on` until something that is placed already, then places the chain from its
/// end. A loop over a list, not a recursion: chains may be as long as the scene.
class Placement {
 public:
  Placement(Scene& scene, const Groups& groups, const BodyNames& names, const SceneSource& source)
      : scene_(scene),
        groups_(groups),
        names_(names),
        source_(source),
        state_(groups.all().size()) {}

  void place_all() {
    for (std::size_t i = 0; i < groups_.all().size(); ++i) {
      place_chain(static_cast<int>(i));
    }
  }

 private:
  enum class State { open, on_the_way, placed };

  [[nodiscard]] const Group& group(int i) const { return groups_.all()[i]; }
  State& state(int i) { return state_[i]; }

  void place_chain(int start) {
    std::vector<int> chain;
    for (int i = start; i >= 0 && state(i) != State::placed; i = carrier(group(i))) {
      if (state(i) == State::on_the_way) fail_cycle(chain, i);
      state(i) = State::on_the_way;
      chain.push_back(i);
    }
    for (; !chain.empty(); chain.pop_back()) {
      place(group(chain.back()));
      state(chain.back()) = State::placed;
    }
  }

  /// The group that `standing` stands on, -1 where it stands at a point.
  [[nodiscard]] int carrier(const Group& standing) const {
    if (standing.standing == nullptr || !standing.standing->on) return -1;
    const BodyRef body = find_body(names_, *standing.standing->on, *standing.origin, "on", source_);
    const int index = groups_.index_of(body);
    std::string_view why;
    if (group(index).placed_by == PlacedBy::pile) {
      why = "is in a pile, which is scattered last and cannot carry anything";
    } else if (group(index).placed_by == PlacedBy::chain) {
      why = "is in a chain, which is laid when all that stands has its place";
    } else if (body.kind == BodyKind::point) {
      why = "is a point, on which nothing can stand";
    }
    if (!why.empty()) {
      fail_at(source_, *standing.origin, "on",
              fmt::format("\"{}\" {}", *standing.standing->on, why));
    }
    return index;
  }

  void place(const Group& placed) {
    if (placed.placed_by != PlacedBy::standing) return;
    const Frame frame = frame_of(placed);
    for (int i = placed.first; i < placed.first + placed.count; ++i) {
      if (placed.kind == BodyKind::cube) {
        SceneCube& cube = scene_.cubes[i];
        cube.position = frame.point(cube.position);
        cube.angle += frame.angle;
      } else {
        SceneFixed& fixed = scene_.fixed[i];
        fixed.position = frame.point(fixed.position);
        fixed.angle += frame.angle;
      }
    }
  }

  [[nodiscard]] Frame frame_of(const Group& placed) const {
    const StandingEntry& standing = *placed.standing;
    if (!standing.on) {
      Frame frame;
      frame.origin = *standing.point;
      return frame;
    }
    const BodyRef body = names_.at(*standing.on);
    if (body.kind == BodyKind::plane) return frame_on(scene_.planes[body.index], standing.offset);
    if (body.kind == BodyKind::fixed) {
      const SceneFixed& box = scene_.fixed[body.index];
      return frame_on_box(box.position, box.angle, box.size, standing.offset);
    }
    const SceneCube& box = scene_.cubes[body.index];
    return frame_on_box(box.position, box.angle, box.size, standing.offset);
  }

  [[noreturn]] void fail_cycle(const std::vector<int>& chain, int again) const {
    constexpr std::ptrdiff_t longest = 10;  // links that are named
    const auto begin = std::find(chain.begin(), chain.end(), again);
    std::string path;
    for (auto i = begin; i != chain.end() && i - begin < longest; ++i) {
      path += fmt::format("\"{}\" on ", group(*i).name);
    }
    if (chain.end() - begin > longest) path += "... on ";
    path += fmt::format("\"{}\"", group(again).name);
    fail_at(source_, *group(chain.back()).origin, "on", "goes round in a circle: " + path);
  }

  Scene& scene_;
  const Groups& groups_;
  const BodyNames& names_;
  const SceneSource& source_;
  std::vector<State> state_;
};

}  // namespace

void place_groups(Scene& scene,
                  const Groups& groups,
                  const BodyNames& names,
                  const SceneSource& source) {
  Placement(scene, groups, names, source).place_all();
}

}  // namespace wuerfel
