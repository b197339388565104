#include <pybind11/pybind11.h>

#include "app/python/answers.h"
#include "app/python/films.h"
#include "app/python/pictures.h"
#include "app/python/scene.h"
#include "app/python/simulation.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "Falling cubes in the plane by Gauss' principle of least constraint.";
  module.attr("__version__") = WUERFEL_VERSION;
  wuerfel::python::bind_errors(module);
  wuerfel::python::bind_scene(module);
  wuerfel::python::bind_check(module);
  wuerfel::python::bind_simulation(module);
  wuerfel::python::bind_pictures(module);
  wuerfel::python::bind_films(module);
}
