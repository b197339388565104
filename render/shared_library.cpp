#include "render/shared_library.h"

#include <dlfcn.h>
#include <utility>

#include "render/error.h"

namespace wuerfel::internal {

SharedLibrary::SharedLibrary(std::string file, const std::string& needs, const std::string& package)
    : file_(std::move(file)),
      handle_(dlopen(file_.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)) {
  if (handle_ != nullptr) return;
  throw LibraryError(needs + ", which could not be loaded (" + dlerror()
                     + "); on Debian it is in the package " + package);
}

void* SharedLibrary::address(const std::string& name) const {
  void* found = dlsym(handle_, name.c_str());
  if (found == nullptr) throw LibraryError(file_ + " has no " + name);
  return found;
}

}  // namespace wuerfel::internal
