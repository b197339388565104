/// Reading files that others named.
#pragma once

#include <istream>
#include <string>
#include <string_view>

namespace wuerfel {

/// All bytes of a file that begins so; of one that begins otherwise, which may be a device without end, no more than that.
std::string file_bytes(std::istream& file, std::string_view beginning);

}  // namespace wuerfel
