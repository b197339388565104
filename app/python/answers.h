/// Verdicts, and errors, as Python has them.
#pragma once

#include <exception>
#include <pybind11/pybind11.h>
#include <vector>

#include "app/python/scene.h"
#include "core/check_many.h"

namespace wuerfel::python {

/// The exception object of something thrown; throws on what stops everything (KeyboardInterrupt).
pybind11::object exception_object(const std::exception_ptr& thrown);

/// Threads that were asked for, 0: one per core. Throws UsageError where there cannot be so many.
int checked_threads(int threads);

/// Scenes from anything that `load_scene` takes, errors in place.
std::vector<Attempt<PyScene>> load_scenes(const std::vector<pybind11::object>& sources);

/// SceneError, RenderError and OutputError of the module.
void bind_errors(pybind11::module_& module);
void bind_check(pybind11::module_& module);

}  // namespace wuerfel::python
