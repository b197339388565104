/// Which commit this program was built from.
#pragma once

#include <string_view>

namespace wuerfel {

/// Twelve hexadecimal digits, with "+" behind them where what it was built from had been changed
/// since; "unknown" outside a git checkout of this project. Written by commit.cmake.
std::string_view commit();

}  // namespace wuerfel
