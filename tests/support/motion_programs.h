/// Programs that the shipped scenes led to while they moved: small, with forces and velocities of
/// very different size, often nearly degenerate. Format: tests/data/README.md.
#pragma once

#include <vector>

#include "tests/support/qp_zoo.h"

namespace wuerfel::test {

/// All of them, in the order in which they were solved. Throws std::runtime_error if they cannot be
/// read.
std::vector<ZooProgram> motion_programs();

}  // namespace wuerfel::test
