/// How deep bodies overlap.
#pragma once

#include "core/constraints/contact.h"

namespace wuerfel::test {

/// Deepest overlap of a state, as a share of the smaller side of the pair.
inline double deepest_overlap(const System& system, const State& state) {
  ContactFinder finder;
  finder.find(system, state);
  return finder.deepest().depth / finder.deepest().scale;
}

}  // namespace wuerfel::test
