// Reading PNG files: libpng for the pixels, our own reader for the texts.
#include <algorithm>
#include <array>
#include <string>

#include "render/error.h"
#include "render/files/file_bytes.h"
#include "render/files/libpng_error.h"
#include "render/files/png.h"
#include "render/files/png_chunks.h"
#include "render/files/png_texts.h"

namespace wuerfel {
namespace {

constexpr std::size_t room_for_texts = std::size_t{256} << 20U;
constexpr std::size_t best_ratio = 1032;  ///< no deflate stream unpacks to more times its size

class Reader {
 public:
  Reader()
      : png_(png_create_read_struct(
          PNG_LIBPNG_VER_STRING, nullptr, internal::throw_png_error, internal::ignore_png_warning)),
        info_(png_create_info_struct(png_)) {}
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  Reader(Reader&&) = delete;
  Reader& operator=(Reader&&) = delete;
  png_structp png() const { return png_; }
  png_infop info() const { return info_; }

 private:
  png_structp png_;
  png_infop info_;
};

void take_bytes(png_structp png, png_bytep target, std::size_t count) {
  auto* source = static_cast<std::span<const std::uint8_t>*>(png_get_io_ptr(png));
  if (count > source->size()) png_error(png, "the file ends too early");
  std::copy_n(source->begin(), count, target);
  *source = source->subspan(count);
}

/// A few bytes can ask for a gigabyte of memory: refused before it is taken.
void require_plausible_size(const Reader& reader, std::span<const internal::PngChunk> chunks) {
  std::size_t packed = 0;
  for (const internal::PngChunk& chunk : chunks)
    if (chunk.type == "IDAT") packed += chunk.data.size();
  const std::size_t row = png_get_rowbytes(reader.png(), reader.info());
  if (row * png_get_image_height(reader.png(), reader.info()) > best_ratio * packed)
    throw RenderError("PNG: the file is too short for its size in pixels");
}

/// Texts are read elsewhere, colours are taken as they stand.
void ignore_all_but_pixels(const Reader& reader) {
  png_set_keep_unknown_chunks(reader.png(), PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
  for (const char* name : {"tEXt", "zTXt", "iTXt", "iCCP", "eXIf", "sPLT"}) {
    png_set_keep_unknown_chunks(reader.png(), PNG_HANDLE_CHUNK_NEVER,
                                reinterpret_cast<const png_byte*>(name), 1);
  }
}

}  // namespace

PngFile decode_png(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < internal::png_signature.size()
      || png_sig_cmp(bytes.data(), 0, internal::png_signature.size()) != 0) {
    throw RenderError("PNG: the file does not begin like one");
  }
  const std::vector<internal::PngChunk> chunks = internal::png_chunks(bytes);
  const Reader reader;
  ignore_all_but_pixels(reader);
  png_set_read_fn(reader.png(), &bytes, take_bytes);
  png_read_info(reader.png(), reader.info());
  require_plausible_size(reader, chunks);
  const png_uint_32 width = png_get_image_width(reader.png(), reader.info());
  const png_uint_32 height = png_get_image_height(reader.png(), reader.info());
  PngFile file{Image(static_cast<int>(std::min<png_uint_32>(width, 1U << 20U)),
                     static_cast<int>(std::min<png_uint_32>(height, 1U << 20U))),
               {}};
  png_set_expand(reader.png());
  png_set_strip_16(reader.png());
  png_set_gray_to_rgb(reader.png());
  png_set_add_alpha(reader.png(), 255, PNG_FILLER_AFTER);
  const int passes = png_set_interlace_handling(reader.png());
  png_read_update_info(reader.png(), reader.info());
  for (int pass = 0; pass < passes; ++pass) {
    for (int y = 0; y < file.image.height(); ++y)
      png_read_row(reader.png(), file.image.row(y), nullptr);
  }
  png_read_end(reader.png(), reader.info());
  file.texts = internal::read_texts(chunks, room_for_texts);
  return file;
}

PngFile read_png(const std::string& path) {
  std::ifstream file = open_to_read(path);
  const std::string signature(internal::png_signature.begin(), internal::png_signature.end());
  const std::string bytes = file_bytes(file, signature);
  try {
    return decode_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  } catch (const RenderError& error) {
    throw RenderError(path + ": " + error.what());
  }
}

}  // namespace wuerfel
