/// The two things that go wrong when pictures are made.
#pragma once

#include <stdexcept>

namespace wuerfel {

/// A picture that cannot be drawn or read as asked: missing OSMesa, unknown layer, damaged PNG.
class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be written: full disk, unwritable folder, ffmpeg missing or failed.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace wuerfel
