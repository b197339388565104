// PNG files: decoded, or refused. What is decoded equals itself.
#include "render/files/png.h"

#include "render/error.h"
#include "render/raster/compare.h"
#include "tests/fuzz/target.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wuerfel;
  try {
    const PngFile file = decode_png({data, size});
    fuzz::require(compare_images(file.image, file.image, {}).verdict == CompareVerdict::identical);
  } catch (const RenderError&) {
  }
  return 0;
}
