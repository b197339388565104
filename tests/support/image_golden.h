/// Golden pictures: what a picture looked like when somebody last looked at it.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "render/raster/image.h"

namespace wuerfel::test {

/// Succeeds where `actual` is the golden picture `name` (compare.h: equal pixels, else within the
/// limits). A missing golden picture is a failure. On failure `name`.actual.png and
/// `name`.compare.png are left in the build tree.
::testing::AssertionResult matches_golden(const std::string& name, const Image& actual);

/// After this, matches_golden stores its pictures instead and says what changed. `renderer` goes
/// into the manifest.
void update_golden(const std::string& renderer);

}  // namespace wuerfel::test
