#include "app/python/scene.h"

#include <pybind11/stl.h>

#include <fmt/format.h>

#include "core/scene/scene_parser.h"

namespace wuerfel::python {

namespace py = pybind11;

namespace {

std::string type_name(const py::handle& value) {
  return py::str(py::type::handle_of(value).attr("__name__"));
}

// Numbers and arrays of NumPy as those of Python.
py::object plain(const py::object& value) {
  if (py::hasattr(value, "tolist")) return value.attr("tolist")();
  throw py::type_error(fmt::format(
      "a scene holds numbers, texts, true and false, lists and dicts, not {}", type_name(value)));
}

// Letters as they are: escapes of JSON come in pairs where TOML has none.
std::string json_of(const py::handle& value) {
  return py::str(py::module_::import("json").attr("dumps")(
      value, py::arg("default") = py::cpp_function(&plain), py::arg("ensure_ascii") = false));
}

// A value as --set takes it: JSON, but for tables.
std::string toml_of(const py::handle& value) {
  if (py::hasattr(value, "tolist")) return toml_of(value.attr("tolist")());
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (py::isinstance<py::dict>(value)) {
    for (const auto& [key, member] : py::reinterpret_borrow<py::dict>(value))
      add(json_of(py::str(key)) + " = " + toml_of(member));
    return "{" + text + "}";
  }
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) return json_of(value);
  for (const py::handle& item : value)
    add(toml_of(item));
  return "[" + text + "]";
}

// Text has line breaks or braces, or is none at all; a name or a path has neither.
bool is_text(const std::string& source) {
  return source.empty() || source.find_first_of("\n{") != std::string::npos;
}

SceneText text_of(const py::object& source) {
  if (py::isinstance<py::dict>(source)) return {"dict", json_of(source)};
  if (py::isinstance<py::str>(source)) {
    const std::string text = py::str(source);
    return is_text(text) ? SceneText{"text", text} : scene_text(text);
  }
  if (py::hasattr(source, "__fspath__")) return scene_text(py::str(source.attr("__fspath__")()));
  throw py::type_error(
      fmt::format("a scene is a path, a text, a dict or a Scene, not {}", type_name(source)));
}

std::string repr(const PyScene& scene) {
  return fmt::format("<wuerfel.Scene \"{}\": {} cubes>", scene.scene.title,
                     scene.scene.cubes.size());
}

}  // namespace

PyScene PyScene::with(const py::kwargs& keys) const {
  PyScene changed = *this;
  for (const auto& [key, value] : keys)
    changed.overrides.push_back(fmt::format("{}={}", std::string(py::str(key)), toml_of(value)));
  changed.scene = parse(changed.text, changed.overrides);
  return changed;
}

std::string PyScene::json() const { return normalised_scene(scene); }

std::vector<std::string> PyScene::names() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.cubes.size() + scene.points.size(); ++i)
    names.push_back(moving_name(scene, static_cast<int>(i)));
  return names;
}

PyScene load_scene(const py::object& source) {
  if (py::isinstance<PyScene>(source)) return source.cast<PyScene>();
  PyScene loaded{text_of(source), {}, {}};
  loaded.scene = parse(loaded.text, {});
  return loaded;
}

void bind_scene(py::module_& module) {
  py::class_<PyScene>(module, "Scene", "A scene: what `wuerfel run` takes.")
      .def(
          py::init(&load_scene), py::arg("source"),
          "From a path, TOML or JSON text, a dict with the same keys, the name of a shipped scene, "
          "or a Scene.")
      .def_static("load", &load_scene, py::arg("source"), "The same as Scene(source).")
      .def("with_", &PyScene::with,
           "A copy with keys set as by --set: scene.with_(**{\"cube.a.angle\": 0.1}).")
      .def("to_json", &PyScene::json, "JSON text with generators and placements resolved.")
      .def(
          "to_dict",
          [](const PyScene& scene) -> py::object {
            return py::module_::import("json").attr("loads")(scene.json());
          },
          "The same as a dict.")
      .def_property_readonly("title", [](const PyScene& scene) { return scene.scene.title; })
      .def_property_readonly(
          "duration", [](const PyScene& scene) { return scene.scene.duration; }, "s")
      .def_property_readonly("names", &PyScene::names,
                             "Names of the bodies that move, in order: cubes, then point masses.")
      .def_property_readonly(
          "hash", [](const PyScene& scene) { return text_hash(scene.json()); },
          "As in the summary of a run.")
      .def(py::pickle(
          [](const PyScene& scene) {
            return py::make_tuple(scene.text.name, scene.text.text, scene.overrides);
          },
          [](const py::tuple& state) {
            const SceneText text{state[0].cast<std::string>(), state[1].cast<std::string>()};
            const auto overrides = state[2].cast<std::vector<std::string>>();
            return PyScene{text, overrides, parse(text, overrides)};
          }))
      .def("__repr__", &repr)
      .def("__len__", [](const PyScene& scene) { return scene.scene.cubes.size(); })
      .def(
          "__eq__", [](const PyScene& a, const PyScene& b) { return a.scene == b.scene; },
          py::is_operator());
}

}  // namespace wuerfel::python
