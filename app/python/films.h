/// Films and folders of frames.
#pragma once

#include <pybind11/pybind11.h>

namespace wuerfel::python {

void bind_films(pybind11::module_& module);

}  // namespace wuerfel::python
