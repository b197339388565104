#include "render/files/ffmpeg_writer.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "render/error.h"
#include "render/files/png.h"
#include "render/files/yuv.h"

namespace wuerfel::internal {
namespace {

constexpr int palette_side = 16;  ///< ffmpeg wants 16 x 16 colours

/// Frames per second as a fraction of small integers.
std::pair<long, long> fraction(double fps) {
  for (const long denominator : {1L, 2L, 3L, 4L, 1001L, 1000L}) {
    const double numerator = fps * static_cast<double>(denominator);
    if (std::abs(numerator - std::round(numerator)) < 1e-6 * numerator) {
      return {std::lround(numerator), denominator};
    }
  }
  return {std::lround(fps * 1e6), 1000000};
}

std::string rate(double fps, char separator) {
  const auto [numerator, denominator] = fraction(fps);
  return fmt::format("{}{}{}", numerator, separator, denominator);
}

void add_all(std::vector<std::string>& arguments, std::initializer_list<std::string_view> more) {
  for (const std::string_view argument : more)
    arguments.emplace_back(argument);
}

void add_input(std::vector<std::string>& arguments, const AnimationSettings& settings, bool yuv) {
  if (yuv) {
    add_all(arguments, {"-f", "yuv4mpegpipe", "-i", "pipe:0"});
  } else {
    add_all(arguments, {"-f", "rawvideo", "-pix_fmt", "rgba", "-video_size",
                        fmt::format("{}x{}", settings.width, settings.height), "-framerate",
                        rate(settings.fps, '/'), "-i", "pipe:0"});
  }
}

void add_encoder(std::vector<std::string>& arguments,
                 FilmFormat format,
                 const AnimationSettings& settings,
                 const std::string& palette) {
  // A fixed number of threads: the encoders' output depends on it.
  add_all(arguments, {"-threads", "4"});
  switch (format) {
    case FilmFormat::mp4:
      // veryfast makes files 42 % smaller than superfast in the same time. Without frames that look
      // ahead: a third less work for files a seventh larger.
      add_all(arguments, {"-c:v", "libx264", "-preset", "veryfast", "-bf", "0", "-crf", "18",
                          "-movflags", "+faststart"});
      break;
    case FilmFormat::webm:
      add_all(arguments, {"-c:v", "libvpx-vp9", "-deadline", "realtime", "-cpu-used", "8", "-crf",
                          "24", "-b:v", "0", "-row-mt", "1"});
      if (settings.transparent) {
        add_all(arguments, {"-vf",
                            "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=black@0,"
                            "scale=out_color_matrix=bt709:out_range=tv",
                            "-auto-alt-ref", "0"});
      }
      break;
    case FilmFormat::gif:
      if (palette.empty()) {
        add_all(arguments, {"-filter_complex",
                            "split[a][b];[a]palettegen=stats_mode=single:reserve_transparent=1[p];"
                            "[b][p]paletteuse=dither=none:new=1"});
      } else {
        add_all(arguments, {"-filter_complex", "paletteuse=dither=none:diff_mode=rectangle"});
      }
      add_all(arguments, {"-loop", "0"});
      return;
  }
  add_all(arguments,
          {"-pix_fmt", settings.transparent && format == FilmFormat::webm ? "yuva420p" : "yuv420p",
           "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709",
           "-color_range", "tv"});
}

std::vector<std::string> command(FilmFormat format,
                                 const AnimationSettings& settings,
                                 bool yuv,
                                 const std::string& palette,
                                 const std::string& output) {
  std::vector<std::string> arguments;
  // Without -xerror it takes a film that it could not write to its end for a success.
  add_all(arguments, {"ffmpeg", "-hide_banner", "-loglevel", "error", "-nostdin", "-y", "-xerror"});
  add_input(arguments, settings, yuv);
  if (!palette.empty()) add_all(arguments, {"-i", palette});
  add_all(arguments, {"-an"});
  add_encoder(arguments, format, settings, palette);
  // Nothing of the day, the machine or ffmpeg's version in the file.
  add_all(arguments, {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact"});
  arguments.push_back("file:" + output);
  return arguments;
}

/// The colours as a picture, the rest filled with the first; with a transparent one where asked
/// for.
Image palette_picture(const std::vector<Color>& colors, bool transparent) {
  Image picture(palette_side, palette_side, colors.front());
  const std::size_t room = palette_side * palette_side - (transparent ? 1 : 0);
  for (std::size_t i = 0; i < std::min(colors.size(), room); ++i) {
    picture.set(static_cast<int>(i) % palette_side, static_cast<int>(i) / palette_side, colors[i]);
  }
  if (transparent) picture.set(palette_side - 1, palette_side - 1, {0, 0, 0, 0});
  return picture;
}

Image on_white(const Image& frame) {
  Image opaque = frame;
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x) {
      const Color color = frame.at(x, y);
      Color over = mix(rgb(0xFFFFFF), {color.r, color.g, color.b, 255}, color.a / 255.0);
      opaque.set(x, y, over);
    }
  }
  return opaque;
}

}  // namespace

FfmpegWriter::FfmpegWriter(const std::string& path,
                           FilmFormat format,
                           const AnimationSettings& settings)
    : settings_(settings),
      yuv_(format == FilmFormat::mp4 || (format == FilmFormat::webm && !settings.transparent)),
      output_(path) {
  if (!(settings.fps > 0.0) || !std::isfinite(settings.fps)) {
    throw RenderError("a film needs more than 0 frames per second");
  }
  if (format == FilmFormat::gif && settings.fps > 50.0) {
    throw RenderError(
        "a GIF shows at most 50 frames per second; ask for 50 or less, or for .apng, .webm or "
        ".mp4");
  }
  std::string palette;
  if (format == FilmFormat::gif && !settings.palette.empty()) {
    palette_.emplace(path + ".palette.png");
    palette_->write(encode_png(palette_picture(settings.palette, settings.transparent)));
    palette = palette_->temporary_path();
  }
  ffmpeg_.emplace(command(format, settings, yuv_, palette, output_.temporary_path()),
                  settings.while_waiting);
  if (!yuv_) return;
  const std::string header =
      fmt::format("YUV4MPEG2 W{} H{} F{} Ip A1:1 C420mpeg2 XCOLORRANGE=LIMITED\n",
                  even_size(settings.width), even_size(settings.height), rate(settings.fps, ':'));
  if (!ffmpeg_->send({reinterpret_cast<const std::uint8_t*>(header.data()), header.size()})) fail();
}

void FfmpegWriter::fail() {
  const int status = ffmpeg_->wait();
  std::string reason = ffmpeg_->error_output();
  if (reason.empty()) reason = fmt::format("exit status {}", status);
  throw OutputError(fmt::format("ffmpeg failed on {}: {}", output_.path(), reason));
}

void FfmpegWriter::add(const Image& frame) {
  if (frame.width() != settings_.width || frame.height() != settings_.height) {
    throw RenderError(fmt::format("a frame of {}x{} pixels in a film of {}x{}", frame.width(),
                                  frame.height(), settings_.width, settings_.height));
  }
  if (yuv_) {
    constexpr std::string_view marker = "FRAME\n";
    last_frame_.assign(marker.begin(), marker.end());
    append_yuv420(settings_.transparent ? on_white(frame) : frame, last_frame_);
  } else {
    last_frame_.assign(frame.bytes().begin(), frame.bytes().end());
  }
  repeat();
}

void FfmpegWriter::repeat() {
  if (!ffmpeg_->send(last_frame_)) fail();
}

void FfmpegWriter::finish() {
  if (ffmpeg_->wait() != 0) {
    const std::string reason = ffmpeg_->error_output();
    throw OutputError(fmt::format("ffmpeg failed on {}: {}", output_.path(),
                                  reason.empty() ? "no reason given" : reason));
  }
  palette_.reset();
  output_.commit();
}

}  // namespace wuerfel::internal
