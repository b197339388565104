/// PNG files: pixels and the texts they carry.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/raster/row_set.h"

namespace wuerfel {

namespace internal {
class IsalDeflate;
}

/// A text chunk. ASCII is written as tEXt, or zTXt where it is long; all else as iTXt (UTF-8).
struct PngText {
  std::string key;    ///< 1 to 79 Latin letters, digits, spaces
  std::string value;  ///< UTF-8
  friend bool operator==(const PngText&, const PngText&) = default;
};

struct PngFile {
  Image image;
  std::vector<PngText> texts;
};

enum class PngChannels {
  automatic,  ///< RGB where the image is opaque, else RGBA
  rgb,        ///< alpha is left out
  rgba,
};

/// Who compresses. Pixels are equal everywhere; bytes are equal for one encoder and one class of
/// processors.
enum class PngEncoder {
  isa_l,   ///< ISA-L level 1: four to eight times faster than zlib's fastest
  libpng,  ///< zlib level 1: everywhere the same bytes for one version of zlib
};
/// "isa-l", "libpng", else "?".
std::string_view to_string(PngEncoder encoder);

/// The compressed pixels of a PNG file, to be used again with other texts.
struct CompressedImage {
  int width = 0;
  int height = 0;
  bool alpha = false;
  std::vector<std::uint8_t> stream;  ///< zlib, as it stands in IDAT
  std::uint32_t check_sum = 0;       ///< of the IDAT chunk
};

/// Compresses one picture after the other and keeps its memory.
class ImageCompressor {
 public:
  /// Throws LibraryError where the encoder is missing.
  explicit ImageCompressor(PngEncoder encoder = PngEncoder::isa_l);
  ~ImageCompressor();
  ImageCompressor(const ImageCompressor&) = delete;
  ImageCompressor& operator=(const ImageCompressor&) = delete;
  ImageCompressor(ImageCompressor&&) = delete;
  ImageCompressor& operator=(ImageCompressor&&) = delete;

  /// Into an object that may have been used before, whose memory is taken again. Who knows that
  /// what is outside of `changed` is as in the call before saves its work; the result is the
  /// same.
  void compress(const Image& image,
                PngChannels channels,
                CompressedImage& compressed,
                const std::optional<RowSet>& changed = {});

 private:
  std::unique_ptr<internal::IsalDeflate> isal_;  ///< none: libpng
};

/// The chunks of these texts, to be used in several files.
std::vector<std::uint8_t> text_chunks(std::span<const PngText> texts);

/// Makes `file` a PNG file of chunks that are there already.
void assemble_png(const CompressedImage& image,
                  std::span<const std::uint8_t> text_chunks,
                  std::vector<std::uint8_t>& file);

/// Both in one. The same image and texts give the same bytes.
std::vector<std::uint8_t> encode_png(const Image& image,
                                     std::span<const PngText> texts = {},
                                     PngEncoder encoder = PngEncoder::isa_l);

/// Reads what any program wrote (palette, grey, 16 bits become RGBA8). In texts, control characters
/// other than line breaks and tabs, and what is no UTF-8, become U+FFFD. Throws RenderError on
/// damaged data, on pictures larger than their data can be and on texts of more than 256 MB.
PngFile decode_png(std::span<const std::uint8_t> bytes);

/// Throws RenderError where the file is missing or no PNG; the message names it.
PngFile read_png(const std::string& path);

/// The file appears whole or not at all. Throws OutputError with the path and the system's reason.
void write_png(const std::string& path,
               const Image& image,
               std::span<const PngText> texts = {},
               PngEncoder encoder = PngEncoder::isa_l);

}  // namespace wuerfel
