/// Pictures as Python has them: arrays of pixels.
#pragma once

#include <pybind11/pybind11.h>
#include <string>
#include <utility>

#include "app/film/picture_options.h"

namespace wuerfel::python {

/// Options by the names of the command line.
struct PictureNames {
  std::pair<int, int> size{1280, 720};
  std::string layers = to_string(default_layers);
  std::string theme = "light";
  std::string view = "fit";
  double scale = 1.0;

  /// Throws UsageError.
  [[nodiscard]] PictureOptions options() const;
};

void bind_pictures(pybind11::module_& module);

}  // namespace wuerfel::python
