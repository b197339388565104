/// SharedLibrary: a library that is loaded when it is first needed, because loading it takes longer
/// than many a command that needs it not.
#pragma once

#include <string>

namespace wuerfel::internal {

class SharedLibrary {
 public:
  /// Loads `file` and never unloads it. Throws LibraryError that says what `needs` it ("pictures
  /// need OSMesa") and which Debian `package` brings it.
  SharedLibrary(std::string file, const std::string& needs, const std::string& package);

  /// Sets `function` to the address of `name`. Throws LibraryError where there is none.
  template <typename Function>
  void find(const std::string& name, Function& function) const {
    function = reinterpret_cast<Function>(address(name));
  }

 private:
  void* address(const std::string& name) const;
  std::string file_;
  void* handle_;
};

}  // namespace wuerfel::internal
