#include "render/files/png.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <zlib.h>

#include <png.h>

#include "render/error.h"
#include "render/files/deflate.h"
#include "render/files/output_file.h"
#include "render/files/png_chunks.h"

namespace wuerfel {

using internal::append_chunk;
using internal::append_u32;
using internal::chunk_check_sum;

namespace {

constexpr std::size_t compress_longer_than = 512;
// Measured at 1920x1080: level 1 without filters takes a quarter of libpng's default time and 5 %
// more room.
constexpr int zlib_level = 1;
constexpr std::size_t compression_buffer = std::size_t{1} << 18U;

/// libpng reports errors through a callback that must not return; exceptions pass through its C
/// code because it is built with unwind tables on every Debian architecture.
[[noreturn]] void throw_error(png_structp png, png_const_charp message) {
  (void)png;
  throw RenderError(std::string("PNG: ") + message);
}
void ignore_warning(png_structp png, png_const_charp message) {
  (void)png;
  (void)message;
}

/// libpng's two structs for writing.
class Writer {
 public:
  Writer()
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, throw_error, ignore_warning)),
        info_(png_create_info_struct(png_)) {}
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  Writer(Writer&&) = delete;
  Writer& operator=(Writer&&) = delete;
  png_structp png() const { return png_; }
  png_infop info() const { return info_; }

 private:
  png_structp png_;
  png_infop info_;
};

class Reader {
 public:
  Reader()
      : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, throw_error, ignore_warning)),
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

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  auto* target = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  target->insert(target->end(), bytes, bytes + count);
}

void take_bytes(png_structp png, png_bytep target, std::size_t count) {
  auto* source = static_cast<std::span<const std::uint8_t>*>(png_get_io_ptr(png));
  if (count > source->size()) png_error(png, "the file ends too early");
  std::copy_n(source->begin(), count, target);
  *source = source->subspan(count);
}

void append_string(std::string_view text, std::vector<std::uint8_t>& data) {
  data.insert(data.end(), text.begin(), text.end());
}

void append_compressed(std::string_view text, std::vector<std::uint8_t>& data) {
  const std::size_t start = data.size();
  uLongf size = compressBound(text.size());
  data.resize(start + size);
  compress(data.data() + start, &size, reinterpret_cast<const Bytef*>(text.data()), text.size());
  data.resize(start + size);
}

/// tEXt, zTXt or iTXt (PNG specification, section 11.3.4).
void append_text(const PngText& text, std::vector<std::uint8_t>& file) {
  const bool ascii =
      std::ranges::all_of(text.value, [](char c) { return static_cast<signed char>(c) >= 0; });
  const bool compress_it = text.value.size() > compress_longer_than;
  std::vector<std::uint8_t> data;
  append_string(text.key, data);
  data.push_back(0);
  if (!ascii) {
    data.push_back(compress_it ? 1 : 0);
    data.insert(data.end(), 3, 0);  // deflate, no language, no translated key
  } else if (compress_it) {
    data.push_back(0);
  }
  if (compress_it) {
    append_compressed(text.value, data);
  } else {
    append_string(text.value, data);
  }
  append_chunk(!ascii ? "iTXt" : compress_it ? "zTXt" : "tEXt", data, file);
}

std::vector<PngText> texts_of(const Reader& reader) {
  png_textp chunks = nullptr;
  int count = 0;
  png_get_text(reader.png(), reader.info(), &chunks, &count);
  std::vector<PngText> texts;
  for (int i = 0; i < count; ++i) {
    const std::size_t length = std::max(chunks[i].text_length, chunks[i].itxt_length);
    texts.push_back({chunks[i].key, std::string(chunks[i].text, length)});
  }
  return texts;
}

/// Four bytes at a time; the fourth is overwritten by the next pixel. `rgb` has a byte to spare for
/// the last one.
void copy_rgb(const std::uint8_t* rgba, int width, std::uint8_t* rgb) {
  for (int x = 0; x < width; ++x, rgba += 4, rgb += 3)
    std::memcpy(rgb, rgba, 4);
}

std::vector<std::uint8_t> stream_by_libpng(const Image& image, bool alpha) {
  std::vector<std::uint8_t> file;
  const Writer writer;
  png_set_write_fn(writer.png(), &file, append_bytes, nullptr);
  png_set_compression_level(writer.png(), zlib_level);
  png_set_filter(writer.png(), PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_compression_buffer_size(writer.png(), compression_buffer);
  png_set_IHDR(writer.png(), writer.info(), static_cast<png_uint_32>(image.width()),
               static_cast<png_uint_32>(image.height()), 8,
               alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(writer.png(), writer.info());
  // Leaving alpha out here is faster than libpng's filler.
  std::vector<std::uint8_t> rgb(3 * image.width() + 1);
  for (int y = 0; y < image.height(); ++y) {
    if (!alpha) copy_rgb(image.row(y), image.width(), rgb.data());
    png_write_row(writer.png(), alpha ? image.row(y) : rgb.data());
  }
  png_write_end(writer.png(), writer.info());
  std::vector<std::uint8_t> stream;
  for (const internal::PngChunk& chunk : internal::png_chunks(file)) {
    if (chunk.type == "IDAT") stream.insert(stream.end(), chunk.data.begin(), chunk.data.end());
  }
  return stream;
}

}  // namespace

std::string_view to_string(PngEncoder encoder) {
  switch (encoder) {
    case PngEncoder::run_length:
      return "run-length";
    case PngEncoder::libpng:
      return "libpng";
  }
  return "?";
}

void compress_image(const Image& image,
                    PngEncoder encoder,
                    PngChannels channels,
                    CompressedImage& compressed) {
  compressed.width = image.width();
  compressed.height = image.height();
  compressed.alpha =
      channels == PngChannels::rgba || (channels == PngChannels::automatic && !image.opaque());
  if (encoder == PngEncoder::libpng) {
    compressed.stream = stream_by_libpng(image, compressed.alpha);
  } else {
    deflate_image(image, compressed.alpha ? 4 : 3, compressed.stream);
  }
  compressed.check_sum = chunk_check_sum("IDAT", compressed.stream);
}

CompressedImage compress_image(const Image& image, PngEncoder encoder, PngChannels channels) {
  CompressedImage compressed;
  compress_image(image, encoder, channels, compressed);
  return compressed;
}

std::vector<std::uint8_t> text_chunks(std::span<const PngText> texts) {
  std::vector<std::uint8_t> chunks;
  for (const PngText& text : texts)
    append_text(text, chunks);
  return chunks;
}

void assemble_png(const CompressedImage& image,
                  std::span<const std::uint8_t> text_chunks,
                  std::vector<std::uint8_t>& file) {
  constexpr std::size_t all_else = 128;  // signature, header, frames of the chunks
  file.reserve(image.stream.size() + text_chunks.size() + all_else);
  file.assign(internal::png_signature.begin(), internal::png_signature.end());
  std::vector<std::uint8_t> header;
  append_u32(static_cast<std::uint32_t>(image.width), header);
  append_u32(static_cast<std::uint32_t>(image.height), header);
  constexpr std::uint8_t depth = 8;
  header.insert(header.end(), {depth, static_cast<std::uint8_t>(image.alpha ? 6 : 2), 0, 0, 0});
  append_chunk("IHDR", header, file);
  file.insert(file.end(), text_chunks.begin(), text_chunks.end());
  append_chunk("IDAT", image.stream, image.check_sum, file);
  append_chunk("IEND", {}, file);
}

std::vector<std::uint8_t> encode_png(const Image& image,
                                     std::span<const PngText> texts,
                                     PngEncoder encoder) {
  std::vector<std::uint8_t> file;
  assemble_png(compress_image(image, encoder), text_chunks(texts), file);
  return file;
}

PngFile decode_png(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t signature_size = 8;
  if (bytes.size() < signature_size || png_sig_cmp(bytes.data(), 0, signature_size) != 0) {
    throw RenderError("PNG: the file does not begin like one");
  }
  const Reader reader;
  png_set_read_fn(reader.png(), &bytes, take_bytes);
  png_read_info(reader.png(), reader.info());
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
  file.texts = texts_of(reader);
  return file;
}

PngFile read_png(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw RenderError("cannot read " + path);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file),
                                std::istreambuf_iterator<char>()};
  try {
    return decode_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  } catch (const RenderError& error) {
    throw RenderError(path + ": " + error.what());
  }
}

void write_png(const std::string& path,
               const Image& image,
               std::span<const PngText> texts,
               PngEncoder encoder) {
  OutputFile file(path);
  file.write(encode_png(image, texts, encoder));
  file.commit();
}

}  // namespace wuerfel
