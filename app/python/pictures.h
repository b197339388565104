/// Pictures as Python has them: arrays of pixels.
#pragma once

#include <pybind11/pybind11.h>

namespace wuerfel::python {

void bind_pictures(pybind11::module_& module);

}  // namespace wuerfel::python
