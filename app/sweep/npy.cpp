#include "app/sweep/npy.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/cli/exit_code.h"
#include "app/sweep/digest.h"

namespace wuerfel {

namespace {

static_assert(std::endian::native == std::endian::little);

std::string header(std::string_view kind, const std::vector<std::size_t>& shape) {
  const std::string sizes =
      fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
  std::string text =
      fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", kind, sizes);
  constexpr std::size_t before = 10;  // magic, version and length of the text
  constexpr std::size_t grain = 64;
  text.append(grain - (before + text.size() + 1) % grain, ' ');
  text += '\n';
  const auto length = static_cast<std::uint16_t>(text.size());
  std::string start("\x93NUMPY\x01\x00", 8);
  start += static_cast<char>(length & 0xffU);
  start += static_cast<char>(length >> 8U);
  return start + text;
}

template <class T>
std::string bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

// Of well-formed UTF-8.
std::vector<char32_t> code_points(const std::string& text) {
  std::vector<char32_t> points;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0U) == 0x80U && !points.empty()) {
      points.back() = points.back() << 6U | (byte & 0x3fU);
    } else {
      const int bits = byte < 0x80U ? 7 : byte < 0xe0U ? 5 : byte < 0xf0U ? 4 : 3;
      points.push_back(byte & ((1U << static_cast<unsigned>(bits)) - 1U));
    }
  }
  return points;
}

void put(std::string& bytes, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i)
    bytes += static_cast<char>(value >> (8U * static_cast<unsigned>(i)) & 0xffU);
}

}  // namespace

std::string npy_of(std::span<const double> values, const std::vector<std::size_t>& shape) {
  return header("<f8", shape) + bytes_of(values);
}

std::string npy_of(std::span<const std::int64_t> values) {
  return header("<i8", {values.size()}) + bytes_of(values);
}

std::string npy_of(const std::vector<bool>& values) {
  std::string bytes = header("|b1", {values.size()});
  for (const bool value : values)
    bytes += value ? '\x01' : '\x00';
  return bytes;
}

std::string npy_of(std::span<const std::string> values) {
  std::vector<std::vector<char32_t>> texts;
  std::size_t longest = 1;
  for (const std::string& value : values) {
    texts.push_back(code_points(value));
    longest = std::max(longest, texts.back().size());
  }
  std::string bytes = header(fmt::format("<U{}", longest), {values.size()});
  for (std::vector<char32_t>& text : texts) {
    text.resize(longest);
    bytes += bytes_of(std::span<const char32_t>(text));
  }
  return bytes;
}

// Local file headers, then the central directory [PKWARE APPNOTE 4.3.7, 4.3.12, 4.3.16].
void NpzFile::add(const std::string& name, const std::string& npy) {
  const std::string file = name + ".npy";
  const auto offset = files_.size();
  if (offset + npy.size() > std::numeric_limits<std::uint32_t>::max())
    throw UsageError("labels.npz would be larger than 4 GB");
  std::string common;
  put(common, 20, 2);             // version needed
  put(common, 0, 2);              // flags
  put(common, 0, 2);              // stored
  put(common, 0, 2);              // midnight
  put(common, 1U << 5U | 1U, 2);  // of 1 January 1980, the first day there is
  put(common, crc32_of(npy), 4);
  put(common, npy.size(), 4);
  put(common, npy.size(), 4);
  put(common, file.size(), 2);
  put(common, 0, 2);  // extra field
  files_ += "PK\x03\x04" + common + file + npy;
  directory_ += "PK\x01\x02";
  put(directory_, 20, 2);  // version made by
  directory_ += common;
  put(directory_, 0, 2);  // comment
  put(directory_, 0, 2);  // disk
  put(directory_, 0, 2);  // internal attributes
  put(directory_, 0, 4);  // external attributes
  put(directory_, offset, 4);
  directory_ += file;
  ++count_;
}

std::string NpzFile::finish() const {
  std::string end = "PK\x05\x06";
  put(end, 0, 4);  // disks
  put(end, static_cast<std::uint64_t>(count_), 2);
  put(end, static_cast<std::uint64_t>(count_), 2);
  put(end, directory_.size(), 4);
  put(end, files_.size(), 4);
  put(end, 0, 2);
  return files_ + directory_ + end;
}

}  // namespace wuerfel
