/// The functions of ISA-L (Intel's storage library) that are used, found at run time.
#pragma once

#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

namespace wuerfel::internal {

struct IsalLibrary {
  decltype(&::isal_deflate_stateless_init) deflate_init = nullptr;
  decltype(&::isal_deflate_stateless) deflate = nullptr;
  decltype(&::isal_adler32) adler32 = nullptr;
  decltype(&::crc32_gzip_refl) crc32 = nullptr;
};

/// Loads ISA-L on the first call and keeps it. Throws LibraryError where it is missing.
const IsalLibrary& isal_library();

}  // namespace wuerfel::internal
