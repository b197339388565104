#include "render/files/apng_writer.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "render/error.h"
#include "render/files/png.h"
#include "render/files/png_chunks.h"

namespace wuerfel::internal {
namespace {

/// Where the chunk with the number of frames begins: after the signature and the header.
constexpr std::size_t animation_control_at = 8 + 12 + 13;

std::vector<std::uint8_t> animation_control(std::uint32_t frames) {
  std::vector<std::uint8_t> data;
  append_u32(frames, data);
  append_u32(0, data);  // plays for ever
  std::vector<std::uint8_t> chunk;
  append_chunk("acTL", data, chunk);
  return chunk;
}

}  // namespace

ApngWriter::ApngWriter(const std::string& path, const AnimationSettings& settings)
    : settings_(settings), output_(path) {
  if (!(settings.fps > 0.0) || settings.fps > 1000.0) {
    throw RenderError("an animated PNG shows more than 0 and at most 1000 frames per second");
  }
}

/// The signature and the chunks before the first frame's.
void ApngWriter::begin() {
  std::vector<std::uint8_t> still;
  assemble_png(frame_, {}, still);
  buffer_.assign(still.begin(), still.begin() + static_cast<std::ptrdiff_t>(animation_control_at));
  const std::vector<std::uint8_t> control = animation_control(0);
  buffer_.insert(buffer_.end(), control.begin(), control.end());
}

/// The chunk before each frame: its size (it lies in the upper left corner), shown for 1/fps,
/// replacing what was there.
void ApngWriter::add_control(int width, int height) {
  constexpr double denominator_limit = 65535.0;
  double numerator = 1000.0;
  if (settings_.fps * numerator > denominator_limit)
    numerator = std::floor(denominator_limit / settings_.fps);
  std::vector<std::uint8_t> data;
  append_u32(sequence_++, data);
  append_u32(static_cast<std::uint32_t>(width), data);
  append_u32(static_cast<std::uint32_t>(height), data);
  append_u32(0, data);
  append_u32(0, data);
  append_u16(static_cast<std::uint32_t>(numerator), data);
  append_u16(static_cast<std::uint32_t>(std::lround(settings_.fps * numerator)), data);
  data.push_back(0);
  data.push_back(0);
  append_chunk("fcTL", data, buffer_);
}

void ApngWriter::add(const Image& frame) {
  if (frame.width() != settings_.width || frame.height() != settings_.height) {
    throw RenderError(fmt::format("a frame of {}x{} pixels in a film of {}x{}", frame.width(),
                                  frame.height(), settings_.width, settings_.height));
  }
  const PngChannels channels = settings_.transparent ? PngChannels::rgba : PngChannels::rgb;
  compressor_.compress(frame, channels, frame_);
  buffer_.clear();
  if (frames_ == 0) begin();
  add_control(settings_.width, settings_.height);
  add_data(frame_);
  compressor_.compress(Image(1, 1, frame.at(0, 0)), channels, corner_);
}

void ApngWriter::repeat() {
  buffer_.clear();
  add_control(1, 1);
  add_data(corner_);
}

/// The picture data of the frame that the control chunk in the buffer announces; writes both.
void ApngWriter::add_data(const CompressedImage& image) {
  if (frames_ == 0) {
    append_chunk("IDAT", image.stream, image.check_sum, buffer_);
  } else {
    std::vector<std::uint8_t> data;
    append_u32(sequence_++, data);
    data.insert(data.end(), image.stream.begin(), image.stream.end());
    append_chunk("fdAT", data, buffer_);
  }
  output_.write(buffer_);
  ++frames_;
}

void ApngWriter::finish() {
  if (frames_ == 0) throw OutputError("a film needs at least one frame: " + output_.path());
  buffer_.clear();
  append_chunk("IEND", {}, buffer_);
  output_.write(buffer_);
  output_.patch(animation_control_at, animation_control(frames_));
  output_.commit();
}

}  // namespace wuerfel::internal
