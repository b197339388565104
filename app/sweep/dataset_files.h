/// Names of the files of a data set.
#pragma once

namespace wuerfel {

inline constexpr const char* plan_folder = "plan";
inline constexpr const char* sums_name = "SHA256SUMS";

}  // namespace wuerfel
