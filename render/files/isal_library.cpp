#include "render/files/isal_library.h"

#include "render/shared_library.h"

namespace wuerfel::internal {
namespace {

IsalLibrary load() {
  const SharedLibrary file("libisal.so.2", "PNG files need ISA-L (or --encoder libpng)",
                           "libisal2");
  IsalLibrary library;
  file.find("isal_deflate_stateless_init", library.deflate_init);
  file.find("isal_deflate_stateless", library.deflate);
  file.find("isal_adler32", library.adler32);
  file.find("crc32_gzip_refl", library.crc32);
  return library;
}

}  // namespace

const IsalLibrary& isal_library() {
  static const IsalLibrary library = load();
  return library;
}

}  // namespace wuerfel::internal
