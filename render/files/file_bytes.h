/// Reading files that others named.
#pragma once

#include <fstream>
#include <istream>
#include <string>
#include <string_view>

namespace wuerfel {

/// Throws RenderError where there is no file of that name, or none that can be read, with the reason.
std::ifstream open_to_read(const std::string& path);

/// All bytes of a file that begins so; of one that begins otherwise, which may be a device without end, no more than that.
std::string file_bytes(std::istream& file, std::string_view beginning);

}  // namespace wuerfel
