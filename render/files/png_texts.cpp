#include "render/files/png_texts.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <zlib.h>

#include "render/error.h"
#include "render/picture/font.h"

namespace wuerfel::internal {
namespace {

constexpr std::size_t compress_longer_than = 512;

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

[[noreturn]] void damaged() { throw RenderError("PNG: a text is damaged"); }

/// Takes the part of `data` before the next zero byte, and that byte.
std::string_view take_word(std::string_view& data) {
  const std::size_t end = data.find('\0');
  if (end == std::string_view::npos) damaged();
  const std::string_view word = data.substr(0, end);
  data.remove_prefix(end + 1);
  return word;
}

char take_byte(std::string_view& data) {
  if (data.empty()) damaged();
  const char byte = data.front();
  data.remove_prefix(1);
  return byte;
}

/// zlib's reader, released at the end of the scope.
class Inflation {
 public:
  explicit Inflation(std::string_view packed) {
    // zlib does not write to its input.
    stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data()));
    stream_.avail_in = static_cast<uInt>(packed.size());
    if (inflateInit(&stream_) != Z_OK) throw std::bad_alloc();
  }
  ~Inflation() { inflateEnd(&stream_); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  Inflation(Inflation&&) = delete;
  Inflation& operator=(Inflation&&) = delete;

  /// All of it, or an error where that is more than `room` bytes.
  std::string text(std::size_t room) {
    std::string text;
    std::array<char, 16384> part{};
    for (int state = Z_OK; state != Z_STREAM_END;) {
      stream_.next_out = reinterpret_cast<Bytef*>(part.data());
      stream_.avail_out = static_cast<uInt>(part.size());
      state = inflate(&stream_, Z_NO_FLUSH);
      if (state != Z_OK && state != Z_STREAM_END) damaged();
      text.append(part.data(), part.size() - stream_.avail_out);
      if (text.size() > room) throw RenderError("PNG: its texts are too long");
    }
    return text;
  }

 private:
  z_stream stream_{};
};

/// The text with U+FFFD in place of what is no UTF-8 and of control characters, which a terminal
/// would obey.
std::string harmless(std::string_view text) {
  constexpr std::string_view replacement = "\uFFFD";
  constexpr char32_t first_printable = 0x20;
  std::string kept;
  kept.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t start = at;
    const char32_t letter = next_code_point(text, at);
    const bool layout = letter == U'\n' || letter == U'\t' || letter == U'\r';
    const bool control = (letter < first_printable && !layout) || (letter >= 0x7F && letter < 0xA0);
    const bool broken = letter == 0xFFFD || (letter >= 0xD800 && letter < 0xE000);
    kept += control || broken ? replacement : text.substr(start, at - start);
  }
  return kept;
}

PngText read_text(const PngChunk& chunk, std::size_t room) {
  std::string_view data(reinterpret_cast<const char*>(chunk.data.data()), chunk.data.size());
  const std::string_view key = take_word(data);
  bool compressed = chunk.type == "zTXt";
  if (chunk.type == "iTXt") compressed = take_byte(data) == 1;
  if (chunk.type != "tEXt" && take_byte(data) != 0) damaged();  // a method that nobody knows
  if (chunk.type == "iTXt") {
    take_word(data);  // language
    take_word(data);  // key in that language
  }
  if (!compressed && data.size() > room) throw RenderError("PNG: its texts are too long");
  return {harmless(key), harmless(compressed ? Inflation(data).text(room) : std::string(data))};
}

}  // namespace

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

std::vector<PngText> read_texts(std::span<const PngChunk> chunks, std::size_t room) {
  std::vector<PngText> texts;
  for (const PngChunk& chunk : chunks) {
    if (chunk.type != "tEXt" && chunk.type != "zTXt" && chunk.type != "iTXt") continue;
    texts.push_back(read_text(chunk, room));
    room -= std::min(room, texts.back().value.size());
  }
  return texts;
}

}  // namespace wuerfel::internal
