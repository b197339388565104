#include "core/time/first_moment.h"

#include <sstream>

#include "core/scene/scene_parser.h"

namespace wuerfel {

Moment first_moment(const Scene& scene, const System& system) {
  Moment moment;
  moment.state = initial_state(scene);
  ContactFinder finder;
  std::vector<Contact> contacts;
  finder.find(system, moment.state, contacts);
  const ContactFinder::Overlap& overlap = finder.deepest();
  if (overlap.depth > touch_tolerance * overlap.scale) {
    std::ostringstream message;
    message << "bodies \"" << system.body(overlap.a).name << "\" and \""
            << system.body(overlap.b).name << "\" overlap by " << overlap.depth
            << " m; move one of them";
    throw SceneError(message.str());
  }
  return moment;
}

}  // namespace wuerfel
