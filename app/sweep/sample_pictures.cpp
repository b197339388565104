#include "app/sweep/sample_pictures.h"

#include "app/film/origin.h"
#include "app/sweep/instance_mask.h"
#include "core/scene/scene_parser.h"
#include "render/files/png.h"
#include "render/picture/compose_frame.h"

namespace wuerfel {

PictureOptions picture_options(const SampleFiles& files) {
  constexpr double wider = 0.8;  // zoom: room for what falls
  PictureOptions options;
  options.size = files.size;
  options.layers = files.layers;
  options.theme = files.theme;
  options.fit = Fit::instant;
  options.average = 0.0;
  options.camera.zoom = wider;
  if (!files.view) return options;
  options.camera.kind = Camera::Kind::fixed;
  options.camera.center = {(*files.view)[0], (*files.view)[1]};
  options.camera.width = (*files.view)[2];
  options.camera.zoom = 1.0;
  return options;
}

PictureOptions fit_to_first(const PictureOptions& options,
                            const Scene& scene,
                            const Snapshot& first,
                            const StopSignal& stop) {
  const MotionSource source{scene, {}, {}, {}, {}, {}, stop};
  Recording motion(source);
  motion.add(first);
  return fit_to_motion(options, motion);
}

Renderer& Renderers::mine() {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<Renderer>& renderer = all_[std::this_thread::get_id()];
  if (!renderer) renderer = std::make_unique<Renderer>();
  return *renderer;
}

SamplePictures::SamplePictures(const Scene& scene,
                               const SampleFiles& files,
                               const Snapshot& first,
                               const StopSignal& stop,
                               Renderer& renderer)
    : renderer_(renderer),
      fitted_(fit_to_first(picture_options(files), scene, first, stop)),
      style_(make_style(fitted_.theme)),
      frame_(frame_options(fitted_)),
      scene_(normalised_scene(scene)) {}

const Image& SamplePictures::pixels(const Snapshot& snapshot) {
  renderer_.draw(
      compose_frame(snapshot, view_of(fitted_, snapshot), style_, frame_, renderer_.font()),
      image_);
  return image_;
}

std::string SamplePictures::frame(const Snapshot& snapshot) {
  std::vector<PngText> texts{time_text({snapshot.time})};
  for (PngText& text :
       origin_texts(option_text(fitted_) + " " + option_text(MotionSettings{}), scene_))
    texts.push_back(std::move(text));
  const std::vector<std::uint8_t> png = encode_png(pixels(snapshot), texts, PngEncoder::libpng);
  return {png.begin(), png.end()};
}

std::string SamplePictures::instances(const Snapshot& snapshot) const {
  return gray_png(instance_mask(snapshot, view_of(fitted_, snapshot)));
}

std::string SamplePictures::numbered(const Snapshot& snapshot,
                                     std::span<const std::uint16_t> numbers) const {
  return gray_png(number_mask(snapshot, view_of(fitted_, snapshot), numbers));
}

}  // namespace wuerfel
