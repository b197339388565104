#include "app/python/answers.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/choice.h"
#include "app/commands/check_json.h"
#include "app/commands/statics_options.h"
#include "app/output/replay.h"
#include "app/output/why.h"
#include "app/python/interruption.h"
#include "app/python/simulation.h"
#include "core/scene/scene_parser.h"
#include "render/error.h"

namespace wuerfel::python {

namespace py = pybind11;

namespace {

/// An answer, as arrays and with the keys of `check --json`.
struct PyCheck {
  PyScene scene;
  Check answer;
  nlohmann::ordered_json json;
  py::object data;  ///< the same as a dict, once somebody has asked for it
};

py::dict dict_of(const nlohmann::ordered_json& json) {
  return py::module_::import("json").attr("loads")(json.dump());
}

/// What is asked for besides the verdict.
StaticsRequest request_of(bool margin, bool ranges, const std::vector<std::string>& bodies) {
  StaticsRequest request;
  if (margin) request.margin.emplace();
  request.ranges = ranges;
  request.bodies = bodies;
  return request;
}

/// Made without the GIL.
struct Answer {
  Check check;
  nlohmann::ordered_json json;
};

Answer answer(const Scene& scene, const StaticsRequest& request, const MotionSettings& settings) {
  Answer made{wuerfel::check(scene, settings), {}};
  made.json = check_json(scene, made.check);
  Notes notes(Notes::Voice::quiet);
  StaticsAnswer(scene, settings, request, made.check.verdict, notes).add_to(made.json);
  return made;
}

std::vector<py::dict> replay(const std::string& path) {
  std::vector<nlohmann::ordered_json> programs;
  {
    const py::gil_scoped_release others_run;
    replay_programs(path, [&](const auto& program) { programs.push_back(program); });
  }
  std::vector<py::dict> dicts;
  for (const nlohmann::ordered_json& program : programs)
    dicts.push_back(dict_of(program));
  return dicts;
}

py::array_t<double> accelerations(const PyCheck& check) {
  py::array_t<double> array(
      {static_cast<py::ssize_t>(check.answer.accelerations.size()), py::ssize_t{3}});
  double* row = array.mutable_data();
  for (const Twist& a : check.answer.accelerations) {
    *row++ = a.linear.x();
    *row++ = a.linear.y();
    *row++ = a.angular;
  }
  return array;
}

MotionSettings settings_of(const std::string& formulation, const std::string& solver) {
  MotionSettings settings;
  settings.formulation = parse_choice<Formulation>("formulation", formulation);
  settings.solver = parse_choice<QpMethod>("solver", solver);
  return settings;
}

PyCheck check_one(const py::object& source,
                  const StaticsRequest& request,
                  const MotionSettings& settings) {
  PyScene scene = load_scene(source);
  Answer made;
  {
    const py::gil_scoped_release others;
    made = answer(scene.scene, request, settings);
  }
  return {std::move(scene), std::move(made.check), std::move(made.json), {}};
}

py::list check_many(const std::vector<py::object>& sources,
                    const StaticsRequest& request,
                    const MotionSettings& settings,
                    int threads) {
  const std::vector<Attempt<PyScene>> scenes = load_scenes(sources);
  Interruption interruption;
  std::vector<Attempt<Answer>> attempts;
  {
    const py::gil_scoped_release others;
    attempts = work_on_each({thread_count(checked_threads(threads)), [&] { interruption.check(); }},
                            static_cast<int>(scenes.size()), [&](int i) {
                              return attempt([&] {
                                if (scenes[i].failure) std::rethrow_exception(scenes[i].failure);
                                return answer(scenes[i].answer.scene, request, settings);
                              });
                            });
  }
  py::list results;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    auto& [made, failure] = attempts[i];
    if (failure != nullptr)
      results.append(exception_object(failure));
    else
      results.append(PyCheck{scenes[i].answer, std::move(made.check), std::move(made.json), {}});
  }
  return results;
}

py::dict explain_one(const py::object& source,
                     const std::string& language,
                     const MotionSettings& settings) {
  const PyScene scene = load_scene(source);
  const Language spoken = parse_choice<Language>("language", language);
  nlohmann::ordered_json json;
  {
    const py::gil_scoped_release others;
    const Explanation explanation = wuerfel::explain(scene.scene, settings);
    json = why_json(explanation, sentences(scene.scene, explanation, spoken));
  }
  return dict_of(json);
}

py::dict data_of(PyCheck& check) {
  if (!check.data) check.data = dict_of(check.json);
  return check.data;
}

py::object key_of(PyCheck& check, const char* key) {
  const py::dict data = data_of(check);
  return data.contains(key) ? py::object(data[key]) : py::none();
}

}  // namespace

py::object exception_object(const std::exception_ptr& thrown) {
  const py::module_ module = py::module_::import("wuerfel");
  try {
    std::rethrow_exception(thrown);
  } catch (const py::error_already_set&) {
    throw;
  } catch (const SceneError& error) {
    return module.attr("SceneError")(error.what());
  } catch (const std::exception& error) {
    return py::reinterpret_borrow<py::object>(PyExc_RuntimeError)(error.what());
  }
}

int checked_threads(int threads) {
  constexpr long most = 1024;
  return static_cast<int>(parse_whole("threads", std::to_string(threads), 0, most));
}

std::vector<Attempt<PyScene>> load_scenes(const std::vector<py::object>& sources) {
  std::vector<Attempt<PyScene>> scenes;
  for (const py::object& source : sources) {
    try {
      scenes.push_back({load_scene(source), nullptr});
    } catch (const SceneError&) {
      scenes.push_back({{}, std::current_exception()});
    }
  }
  return scenes;
}

void bind_errors(py::module_& module) {
  py::register_exception<SceneError>(module, "SceneError", PyExc_ValueError);
  py::register_exception<RenderError>(module, "RenderError", PyExc_ValueError);
  py::register_exception<OutputError>(module, "OutputError", PyExc_OSError);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const UsageError& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
}

void bind_check(py::module_& module) {
  py::class_<PyCheck>(module, "Check", "What `wuerfel check` answers; true where the scene stands.")
      .def_property_readonly(
          "verdict",
          [](const PyCheck& check) { return std::string(to_string(check.answer.verdict)); },
          "stands, falls, moves or undecided")
      .def_property_readonly("accelerations", &accelerations,
                             "(cubes, 3) float64: ax, ay (m/s^2), alpha (rad/s^2)")
      .def_property_readonly(
          "contacts", [](PyCheck& c) { return key_of(c, "contacts"); },
          "Dicts with the keys of `check --json`.")
      .def_property_readonly(
          "facts", [](PyCheck& c) { return key_of(c, "facts"); }, "Of scenes that rub, else None.")
      .def_property_readonly(
          "margin", [](PyCheck& c) { return key_of(c, "margin"); },
          "Where it was asked for, with the keys of `check --margin --json`, else None.")
      .def(
          "to_dict", [](PyCheck& c) { return data_of(c); },
          "All of it, with the keys of `check --json`.")
      .def_property_readonly("objective", [](const PyCheck& c) { return c.answer.objective; })
      .def_property_readonly("kkt_residual", [](const PyCheck& c) { return c.answer.kkt_residual; })
      .def_property_readonly("names", [](const PyCheck& c) { return c.scene.names(); })
      .def("__bool__", [](const PyCheck& c) { return c.answer.verdict == Verdict::stands; })
      .def("__repr__", [](const PyCheck& c) {
        return fmt::format("<wuerfel.Check: {}>", to_string(c.answer.verdict));
      });
  const MotionNames usual;
  module.def(
      "check",
      [](const py::object& scene, bool margin, bool ranges, const std::vector<std::string>& bodies,
         const std::string& formulation, const std::string& solver) {
        return check_one(scene, request_of(margin, ranges, bodies),
                         settings_of(formulation, solver));
      },
      py::arg("scene"), py::kw_only(), py::arg("margin") = false, py::arg("ranges") = false,
      py::arg("bodies") = std::vector<std::string>{}, py::arg("formulation") = usual.formulation,
      py::arg("solver") = usual.solver,
      "Whether the scene stands at t = 0, without simulating; with margin how nearly, with ranges "
      "between which values forces may lie. Other threads run meanwhile.");
  module.def(
      "explain",
      [](const py::object& scene, const std::string& language, const std::string& formulation,
         const std::string& solver) {
        return explain_one(scene, language, settings_of(formulation, solver));
      },
      py::arg("scene"), py::kw_only(), py::arg("language") = "en",
      py::arg("formulation") = usual.formulation, py::arg("solver") = usual.solver,
      "Why a scene falls and what would help, or how nearly it stands: a dict with the keys of "
      "`explain --json`; \"text\" has the sentences.");
  module.def(
      "replay", &replay, py::arg("path"),
      "Solves the programs again that `run --failed-programs` kept: a dict for each, with the "
      "keys of `replay --json`.");
  module.def(
      "check_many",
      [](const std::vector<py::object>& scenes, int threads, bool margin, bool ranges,
         const std::string& formulation, const std::string& solver) {
        return check_many(scenes, request_of(margin, ranges, {}), settings_of(formulation, solver),
                          threads);
      },
      py::arg("scenes"), py::kw_only(), py::arg("threads") = 0, py::arg("margin") = false,
      py::arg("ranges") = false, py::arg("formulation") = usual.formulation,
      py::arg("solver") = usual.solver,
      "A Check per scene, in order, by threads (0: one per core); an exception object in "
      "place of one that failed.");
}

}  // namespace wuerfel::python
