#include "app/python/pictures.h"

#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <fmt/format.h>

#include "app/cli/exit_code.h"
#include "app/cli/picture_values.h"
#include "app/film/recording.h"
#include "app/python/simulation.h"
#include "app/sweep/instance_mask.h"
#include "app/sweep/sample_pictures.h"
#include "render/picture/compose_frame.h"

namespace wuerfel::python {

namespace py = pybind11;

namespace {

// One for each thread that draws; they live as long as the module.
Renderer& renderer() {
  static auto& all = *new Renderers;
  return all.mine();
}

/// What a simulation shows as it is, and the options that fit it.
struct Sight {
  Snapshot snapshot;
  PictureOptions options;
};

Sight sight_of(const PySimulation& simulation, PictureOptions options) {
  const Scene& scene = simulation.scene().scene;
  options.color_by = color_by(options, scene.cubes.size());
  options.average = 0.0;
  const SnapshotRequest request = snapshot_request(options, scene.cubes.size());
  const StopSignal deaf(StopSignal::Ear::deaf);
  const MotionSource source{scene, {}, {}, request, request, {}, deaf};
  Recording motion(source);
  Snapshot snapshot = simulation.get().snapshot(request);
  motion.add(snapshot);
  return {std::move(snapshot), fit_to_motion(options, motion)};
}

Image draw(const Sight& sight) {
  Image image;
  renderer().draw(compose_frame(sight.snapshot, view_of(sight.options, sight.snapshot),
                                make_style(sight.options.theme), frame_options(sight.options),
                                renderer().font()),
                  image);
  return image;
}

// The array owns the pixels.
py::object array_of(Image drawn) {
  auto image = std::make_unique<Image>(std::move(drawn));
  const py::array::ShapeContainer shape{image->height(), image->width(), 4};
  std::uint8_t* data = image->data();
  const py::capsule owner(image.release(), [](void* p) { delete static_cast<Image*>(p); });
  return py::array_t<std::uint8_t>(shape, data, owner);
}

py::object array_of(const NumberImage& image) {
  const py::array::ShapeContainer shape{image.height, image.width};
  return py::array_t<std::uint16_t>(shape, image.values.data());
}

py::object render_at(const PySimulation& simulation,
                     const PictureOptions& options,
                     const std::string& mode) {
  const Sight sight = sight_of(simulation, options);
  if (mode == "instance")
    return array_of(instance_mask(sight.snapshot, view_of(sight.options, sight.snapshot)));
  if (mode != "picture")
    throw UsageError(fmt::format("mode: '{}' is not picture or instance", mode));
  return array_of(draw(sight));
}

py::object render(const py::object& source,
                  double t,
                  const PictureNames& names,
                  const std::string& mode) {
  PictureOptions options = names.options();
  options.fit = Fit::instant;
  if (py::isinstance<PySimulation>(source)) {
    if (t != 0.0) throw UsageError("t is for scenes; a simulation is drawn as it is");
    return render_at(source.cast<const PySimulation&>(), options, mode);
  }
  PySimulation simulation(load_scene(source), {});
  simulation.advance_to(t);
  return render_at(simulation, options, mode);
}

}  // namespace

PictureOptions PictureNames::options() const {
  PictureOptions picture;
  picture.size = parse_pixel_size(fmt::format("{}x{}", size.first, size.second));
  picture.layers = parse_layers(layers);
  picture.theme = parse_theme(theme);
  picture.camera = parse_camera(view);
  require_scale("scale", scale);
  picture.scale = scale;
  return picture;
}

void bind_pictures(py::module_& module) {
  const PictureNames usual;
  module.def(
      "render",
      [](const py::object& scene, double t, std::pair<int, int> size, const std::string& layers,
         const std::string& theme, const std::string& view, double scale, const std::string& mode) {
        return render(scene, t, {size, layers, theme, view, scale}, mode);
      },
      py::arg("scene"), py::kw_only(), py::arg("t") = 0.0, py::arg("size") = usual.size,
      py::arg("layers") = usual.layers, py::arg("theme") = usual.theme,
      py::arg("view") = usual.view, py::arg("scale") = usual.scale, py::arg("mode") = "picture",
      "A picture of a scene at t (s), or of a simulation as it is: (height, width, 4) uint8 RGBA, "
      "the pixels of `wuerfel figure --fit instant`. With mode=\"instance\" (height, width) "
      "uint16: the number of the cube that each pixel shows, from 1, and 0 elsewhere.");
}

}  // namespace wuerfel::python
