/// IsalDeflate: pictures compressed by ISA-L's level 0, several times faster than zlib's fastest
/// level. Its bytes depend on the processor's instructions; their meaning doesn't.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/raster/row_set.h"

namespace wuerfel::internal {

/// Packs bands of some rows each for itself, so that those bands that are as in the picture before
/// need not be packed again. What comes out is the same with and without a picture before.
class IsalDeflate {
 public:
  /// Throws LibraryError where ISA-L is missing.
  IsalDeflate();
  ~IsalDeflate();
  IsalDeflate(const IsalDeflate&) = delete;
  IsalDeflate& operator=(const IsalDeflate&) = delete;
  IsalDeflate(IsalDeflate&&) = delete;
  IsalDeflate& operator=(IsalDeflate&&) = delete;

  /// Makes `stream` the zlib stream of PNG's image data for 8 bits a channel and no filters: each
  /// row a zero byte and then `channels` (3: RGB, 4: RGBA) bytes a pixel. What is outside of `changed`
  /// is as in the call before.
  void compress(const Image& image,
                int channels,
                RowSet changed,
                std::vector<std::uint8_t>& stream);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> work_;
};

/// CRC-32 of a PNG chunk by ISA-L: several times faster than zlib's.
std::uint32_t isal_crc32(std::uint32_t start, const std::vector<std::uint8_t>& bytes);

}  // namespace wuerfel::internal
