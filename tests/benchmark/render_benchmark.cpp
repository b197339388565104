// What drawing and encoding cost, with states prepared beforehand. Build and run, on a machine that
// does nothing else:
//
//   cmake --build build/release --target render_benchmark && build/release/tests/render_benchmark
//
// "clip": 100 cubes with rods fall, a third of them landed and pushed by arrows; as in a film, the
// picture shows the whole motion. "grid": 100 turned cubes that fill the picture, each with rods
// and two arrows. 1920x1080. CPU is the time of the whole process, all threads.
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "render/files/animation.h"
#include "render/files/png.h"
#include "render/picture/compose_frame.h"
#include "render/pipeline/frame_pipeline.h"
#include "render/raster/draw_frame.h"

namespace wuerfel {
namespace {

constexpr int width = 1920;
constexpr int height = 1080;

SnapshotBox cube(double x, double y, double angle, int color) {
  SnapshotBox box;
  box.center = Vec2(x, y);
  box.angle = angle;
  box.color_index = color;
  return box;
}

constexpr int clip_frames = 300;

/// Frame `k` of 100 cubes: 30 lie on the floor, two arrows below each, and 70 fall towards them.
Snapshot clip(int k) {
  Snapshot snapshot;
  snapshot.title = "clip";
  snapshot.time = k / 60.0;
  snapshot.revision = static_cast<std::uint64_t>(k) + 1;
  snapshot.planes.push_back({"floor", Vec2::Zero(), Vec2::UnitY()});
  for (int i = 0; i < 100; ++i) {
    const bool landed = i < 30;
    const int row = i / 15;
    const double fall = landed ? 0.0 : 0.8 * snapshot.time * snapshot.time;
    const double turn = landed ? 0.0 : 0.02 * k + 0.5 * i;
    snapshot.boxes.push_back(
        cube(1.2 * (i % 15), landed ? 0.5 + row : 19.0 + 1.6 * row - fall, turn, i));
    if (!landed) continue;
    for (const double side : {-0.5, 0.5}) {
      snapshot.forces.push_back({snapshot.boxes.back().center + Vec2(side, -0.5),
                                 Vec2(0.0, 10.0 - 4.0 * row), ForceKind::contact, i});
    }
  }
  return snapshot;
}

/// `count` turned cubes that fill the picture, each with two arrows.
Snapshot grid(int count) {
  Snapshot snapshot;
  const int columns = static_cast<int>(std::lround(std::sqrt(count * 16.0 / 9.0)));
  for (int i = 0; i < count; ++i) {
    const int row = i / columns;
    snapshot.boxes.push_back(cube(1.3 * (i % columns), 1.3 * row, 0.3 * i, i));
    for (const double side : {-0.3, 0.3}) {
      snapshot.forces.push_back(
          {snapshot.boxes.back().center + Vec2(side, -0.3), Vec2(0.0, 8.0), ForceKind::contact, i});
    }
  }
  return snapshot;
}

FrameOptions options_with(bool hud) {
  FrameOptions options;
  options.layers = {Layer::cubes, Layer::rods, Layer::forces};
  if (hud) options.layers.insert(Layer::hud);
  options.force_scale.metres_per_newton = 0.1;
  return options;
}

View view_of(const std::vector<Snapshot>& snapshots, const FrameOptions& options) {
  Bounds bounds;
  for (const Snapshot& snapshot : snapshots)
    bounds.include(snapshot, options.force_scale);
  return fit_view(bounds, width, height,
                  frame_insets(make_style(Theme::light), options, width, height));
}

Renderer& shared_renderer() {
  static const std::unique_ptr<Renderer> renderer = std::make_unique<Renderer>();
  return *renderer;
}

/// One picture out of a film.
struct Picture {
  Snapshot snapshot;
  View view;
};

Picture clip_picture() {
  return {clip(clip_frames / 2), view_of({clip(0), clip(clip_frames)}, options_with(true))};
}
Picture grid_picture(int count) {
  const Snapshot snapshot = grid(count);
  return {snapshot, view_of({snapshot}, options_with(true))};
}

void draw(benchmark::State& state, const Picture& picture) {
  const FrameOptions options = options_with(true);
  const Style style = make_style(Theme::light);
  Image image;
  for (auto _ : state)
    draw_frame(shared_renderer(), picture.snapshot, picture.view, style, options, image);
}
void draw_clip(benchmark::State& state) { draw(state, clip_picture()); }
void draw_grid(benchmark::State& state) {
  draw(state, grid_picture(static_cast<int>(state.range(0))));
}

void compose(benchmark::State& state) {
  const auto [snapshot, view] = grid_picture(static_cast<int>(state.range(0)));
  const FrameOptions options = options_with(true);
  const Style style = make_style(Theme::light);
  Font font;
  for (auto _ : state)
    benchmark::DoNotOptimize(compose_frame(snapshot, view, style, options, font));
}

void png(benchmark::State& state, PngEncoder encoder, const Picture& picture) {
  Image image;
  draw_frame(shared_renderer(), picture.snapshot, picture.view, make_style(Theme::light),
             options_with(true), image);
  ImageCompressor compressor(encoder);
  CompressedImage compressed;
  for (auto _ : state)
    compressor.compress(image, PngChannels::rgb, compressed);
  state.counters["kB"] = static_cast<double>(compressed.stream.size()) / 1000.0;
}
void png_isal_clip(benchmark::State& state) { png(state, PngEncoder::isa_l, clip_picture()); }
void png_isal_grid(benchmark::State& state) { png(state, PngEncoder::isa_l, grid_picture(100)); }
void png_libpng_clip(benchmark::State& state) { png(state, PngEncoder::libpng, clip_picture()); }
void png_libpng_grid(benchmark::State& state) { png(state, PngEncoder::libpng, grid_picture(100)); }

/// Frames per second from snapshots to PNG files in memory and, where asked for, to a film.
void pipeline(benchmark::State& state, const std::string& film, PngEncoder encoder, bool moving) {
  const FrameOptions options = options_with(moving);
  const int count = moving ? clip_frames : 20 * clip_frames;
  std::vector<Snapshot> snapshots;
  snapshots.reserve(count);
  for (int k = 0; k < count; ++k)
    snapshots.push_back(clip(moving ? k : 0));
  const View view = view_of({clip(0), clip(clip_frames)}, options);
  AnimationSettings settings;
  settings.width = width;
  settings.height = height;
  std::size_t bytes = 0;
  for (auto _ : state) {
    PipelineOutputs outputs;
    std::unique_ptr<AnimationWriter> writer;
    if (film.empty()) {
      outputs.take_png = [&bytes](std::span<const std::uint8_t> file) { bytes += file.size(); };
    } else {
      writer = make_animation_writer(film, settings);
      outputs.films.push_back(writer.get());
    }
    FramePipeline stages({make_style(Theme::light), options, {}, encoder}, outputs);
    for (const Snapshot& snapshot : snapshots)
      stages.add({snapshot, view, {}});
    stages.finish();
    if (writer) writer->finish();
  }
  state.counters["frames/s"] = benchmark::Counter(
      static_cast<double>(snapshots.size()) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate);
}
void pipeline_png(benchmark::State& state) { pipeline(state, "", PngEncoder::isa_l, true); }
void pipeline_libpng(benchmark::State& state) { pipeline(state, "", PngEncoder::libpng, true); }
void pipeline_unchanged(benchmark::State& state) { pipeline(state, "", PngEncoder::isa_l, false); }
void pipeline_mp4(benchmark::State& state) {
  pipeline(state, "render_benchmark.mp4", PngEncoder::isa_l, true);
}

}  // namespace

BENCHMARK(draw_clip)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(draw_grid)
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(compose)->Arg(100)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(png_isal_clip)->Unit(benchmark::kMillisecond);
BENCHMARK(png_isal_grid)->Unit(benchmark::kMillisecond);
BENCHMARK(png_libpng_clip)->Unit(benchmark::kMillisecond);
BENCHMARK(png_libpng_grid)->Unit(benchmark::kMillisecond);
BENCHMARK(pipeline_png)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(pipeline_libpng)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
BENCHMARK(pipeline_unchanged)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
BENCHMARK(pipeline_mp4)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace wuerfel

BENCHMARK_MAIN();
