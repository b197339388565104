/// What goes wrong when pictures are made.
#pragma once

#include <stdexcept>

namespace wuerfel {

/// A picture that cannot be drawn or read as asked: impossible size, damaged PNG.
class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be written: full disk, unwritable folder, ffmpeg missing or failed.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A library that is loaded when it is first needed (OSMesa, Cairo, ISA-L) is missing or is not
/// what it should be. Like a missing ffmpeg it keeps the output from being made, whatever was
/// asked for.
class LibraryError : public OutputError {
 public:
  using OutputError::OutputError;
};

}  // namespace wuerfel
