#include "render/png.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>

#include <png.h>

#include "render/error.h"
#include "render/output_file.h"

namespace wuerfel {
namespace {

constexpr std::size_t compress_longer_than = 512;
// Measured at 1920x1080: level 1 without filters takes a quarter of libpng's default time and 5 %
// more room.
constexpr int zlib_level = 1;

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

int compression_of(const PngText& text) {
  const bool ascii =
      std::ranges::all_of(text.value, [](char c) { return static_cast<signed char>(c) >= 0; });
  const bool compress = text.value.size() > compress_longer_than;
  if (ascii) return compress ? PNG_TEXT_COMPRESSION_zTXt : PNG_TEXT_COMPRESSION_NONE;
  return compress ? PNG_ITXT_COMPRESSION_zTXt : PNG_ITXT_COMPRESSION_NONE;
}

void set_texts(const Writer& writer, std::span<const PngText> texts, std::vector<PngText>& kept) {
  kept.assign(texts.begin(), texts.end());
  std::vector<png_text> chunks(texts.size());
  std::string no_language;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    chunks[i].compression = compression_of(kept[i]);
    chunks[i].key = kept[i].key.data();
    chunks[i].text = kept[i].value.data();
    chunks[i].text_length = kept[i].value.size();
    chunks[i].lang = no_language.data();
    chunks[i].lang_key = no_language.data();
  }
  if (!chunks.empty())
    png_set_text(writer.png(), writer.info(), chunks.data(), static_cast<int>(chunks.size()));
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

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image,
                                     std::span<const PngText> texts,
                                     PngChannels channels) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height())
                / 4);
  const Writer writer;
  png_set_write_fn(writer.png(), &bytes, append_bytes, nullptr);
  png_set_compression_level(writer.png(), zlib_level);
  png_set_filter(writer.png(), PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_compression_buffer_size(writer.png(), std::size_t{1} << 16U);
  const bool alpha =
      channels == PngChannels::rgba || (channels == PngChannels::automatic && !image.opaque());
  png_set_IHDR(writer.png(), writer.info(), static_cast<png_uint_32>(image.width()),
               static_cast<png_uint_32>(image.height()), 8,
               alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  std::vector<PngText> kept;
  set_texts(writer, texts, kept);
  png_write_info(writer.png(), writer.info());
  if (!alpha) png_set_filler(writer.png(), 0, PNG_FILLER_AFTER);
  for (int y = 0; y < image.height(); ++y)
    png_write_row(writer.png(), image.row(y));
  png_write_end(writer.png(), writer.info());
  return bytes;
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

void write_png(const std::string& path, const Image& image, std::span<const PngText> texts) {
  OutputFile file(path);
  file.write(encode_png(image, texts));
  file.commit();
}

}  // namespace wuerfel
