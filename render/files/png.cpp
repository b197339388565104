#include "render/files/png.h"

#include "render/files/isal_deflate.h"
#include "render/files/libpng_deflate.h"
#include "render/files/output_file.h"
#include "render/files/png_chunks.h"
#include "render/files/png_texts.h"

namespace wuerfel {

using internal::append_chunk;
using internal::append_u32;

std::string_view to_string(PngEncoder encoder) {
  switch (encoder) {
    case PngEncoder::isa_l:
      return "isa-l";
    case PngEncoder::libpng:
      return "libpng";
  }
  return "?";
}

ImageCompressor::ImageCompressor(PngEncoder encoder) {
  if (encoder == PngEncoder::isa_l) isal_ = std::make_unique<internal::IsalDeflate>();
}

ImageCompressor::~ImageCompressor() = default;

void ImageCompressor::compress(const Image& image,
                               PngChannels channels,
                               CompressedImage& compressed,
                               const std::optional<RowSet>& changed) {
  compressed.width = image.width();
  compressed.height = image.height();
  compressed.alpha =
      channels == PngChannels::rgba || (channels == PngChannels::automatic && !image.opaque());
  const std::uint32_t start = internal::chunk_check_sum("IDAT", {});
  if (isal_) {
    isal_->compress(image, compressed.alpha ? 4 : 3, changed.value_or(RowRange{0, image.height()}),
                    compressed.stream);
    compressed.check_sum = internal::isal_crc32(start, compressed.stream);
  } else {
    compressed.stream = internal::libpng_deflate(image, compressed.alpha);
    compressed.check_sum = internal::chunk_check_sum("IDAT", compressed.stream);
  }
}

std::vector<std::uint8_t> text_chunks(std::span<const PngText> texts) {
  std::vector<std::uint8_t> chunks;
  for (const PngText& text : texts)
    internal::append_text(text, chunks);
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
  CompressedImage compressed;
  ImageCompressor(encoder).compress(image, PngChannels::automatic, compressed);
  std::vector<std::uint8_t> file;
  assemble_png(compressed, text_chunks(texts), file);
  return file;
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
