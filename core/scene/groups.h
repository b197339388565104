/// Groups: the bodies of a scene by the table they come from.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/entries.h"
#include "core/scene/overlap.h"

namespace wuerfel {

/// What places the bodies of a group.
enum class PlacedBy {
  itself,    ///< a plane, a point, the joints of a truss
  standing,  ///< a point, or a face of another body
  chain,     ///< two places, after what stands
  pile,      ///< chance, after all others
};

/// The bodies of one table: one for [[plane]], [[fixed]] and [[cube]], many for a generator.
struct Group {
  BodyKind kind = BodyKind::cube;
  int first = 0;  ///< index of its first body within the kind
  int count = 1;
  PlacedBy placed_by = PlacedBy::standing;
  const Origin* origin = nullptr;
  const StandingEntry* standing = nullptr;  ///< null where nothing but itself or chance places it
  std::string name;                         ///< of the body or of the generator
};

/// All groups of a scene, and which group a body is in.
class Groups {
 public:
  void add(Group group);
  [[nodiscard]] const std::vector<Group>& all() const { return groups_; }
  [[nodiscard]] int index_of(const BodyRef& body) const {
    return owner_[static_cast<std::size_t>(body.kind)][body.index];
  }
  [[nodiscard]] const Group& of(const BodyRef& body) const { return groups_[index_of(body)]; }

 private:
  std::vector<Group> groups_;
  std::array<std::vector<int>, 4> owner_;  ///< by kind and index
};

/// Bodies by name; the keys are the names within the scene.
using BodyNames = std::map<std::string_view, BodyRef>;

/// Throws SceneError where two bodies have the same name.
BodyNames collect_names(const Scene& scene, const Groups& groups, const SceneSource& source);

/// The body called `name`; throws SceneError at `key` of `origin` where
/// there is none.
BodyRef find_body(const BodyNames& names,
                  const std::string& name,
                  const Origin& origin,
                  std::string_view key,
                  const SceneSource& source);

/// Where `key` of the table at `origin` stands: its value, or the table where there is no such key.
Place place_of(const Origin& origin, std::string_view key);

/// Throws SceneError about a key of the table at `origin`, or about that table.
[[noreturn]] void fail_at(const SceneSource& source,
                          const Origin& origin,
                          std::string_view key,
                          const std::string& message);
[[noreturn]] void fail_at(const SceneSource& source,
                          const Origin& origin,
                          const std::string& message);

}  // namespace wuerfel
