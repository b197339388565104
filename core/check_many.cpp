#include "core/check_many.h"

namespace wuerfel {

std::vector<Attempt<Check>> check_many(std::span<const Scene> scenes,
                                       const MotionSettings& settings,
                                       const Workforce& workforce) {
  return work_on_each(workforce, static_cast<int>(scenes.size()),
                      [&](int i) { return attempt([&] { return check(scenes[i], settings); }); });
}

}  // namespace wuerfel
