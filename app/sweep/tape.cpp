#include "app/sweep/tape.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <numeric>

#include <fmt/format.h>

#include "app/cli/exit_code.h"

namespace wuerfel {

namespace {

constexpr std::size_t block = 512;  // bytes

/// A header of the ustar format, field by field as POSIX has it (pax, "ustar Interchange Format").
struct Field {
  std::size_t offset;
  std::size_t length;
};
constexpr Field name_field{0, 100};
constexpr Field mode_field{100, 8};
constexpr Field size_field{124, 12};
constexpr Field time_field{136, 12};
constexpr Field sum_field{148, 8};
constexpr Field type_field{156, 1};
constexpr Field magic_field{257, 8};

using Header = std::array<char, block>;

void put(Header& header, Field field, std::string_view text) {
  std::copy_n(text.begin(), std::min(text.size(), field.length),
              header.begin() + static_cast<std::ptrdiff_t>(field.offset));
}

std::string_view get(const Header& header, Field field) {
  const std::string_view text(header.data() + field.offset, field.length);
  return text.substr(0, text.find('\0'));
}

// The sum of all bytes, those of the sum itself taken as blanks.
unsigned sum_of(Header header) {
  put(header, sum_field, "        ");
  return std::accumulate(header.begin(), header.end(), 0U,
                         [](unsigned sum, char c) { return sum + static_cast<unsigned char>(c); });
}

std::string octal(std::size_t value, std::size_t digits) {
  return fmt::format("{:0{}o}", value, digits);
}

Header header_of(const TapeFile& file) {
  Header header{};
  put(header, name_field, file.name);
  put(header, mode_field, "0000644");
  put(header, {108, 8}, "0000000");  // owner
  put(header, {116, 8}, "0000000");  // group
  put(header, size_field, octal(file.bytes.size(), 11));
  put(header, time_field, octal(0, 11));
  put(header, type_field, "0");
  put(header, magic_field,
      std::string_view("ustar\0"
                       "00",
                       8));
  put(header, sum_field, octal(sum_of(header), 6));
  put(header, {sum_field.offset + 7, 1}, " ");
  return header;
}

std::size_t padding(std::size_t size) { return (block - size % block) % block; }

std::optional<std::size_t> number(std::string_view octal_digits) {
  std::size_t value = 0;
  const auto [stop, error] =
      std::from_chars(octal_digits.data(), octal_digits.data() + octal_digits.size(), value, 8);
  if (error != std::errc()) return std::nullopt;
  return value;
}

/// Name and size from a header; nothing where it is none.
std::optional<std::pair<std::string, std::size_t>> read_header(const Header& header) {
  const auto sum = number(get(header, sum_field));
  const auto size = number(get(header, size_field));
  if (!sum || !size || *sum != sum_of(header)) return std::nullopt;
  return std::pair{std::string(get(header, name_field)), *size};
}

bool is_blank(const Header& header) {
  return std::ranges::all_of(header, [](char c) { return c == '\0'; });
}

}  // namespace

std::string tape_blocks(const std::vector<TapeFile>& files) {
  std::string blocks;
  for (const TapeFile& file : files) {
    const Header header = header_of(file);
    blocks.append(header.data(), header.size());
    blocks += file.bytes;
    blocks.append(padding(file.bytes.size()), '\0');
  }
  return blocks;
}

std::string tape_end() { return std::string(2 * block, '\0'); }

TapeReader::TapeReader(std::string path) : path_(std::move(path)), file_(path_, std::ios::binary) {
  if (!file_) fail("cannot be read");
}

void TapeReader::fail(const std::string& message) const {
  throw UsageError(fmt::format("{}: {}", path_, message));
}

std::optional<TapeFile> TapeReader::next() {
  Header header{};
  file_.read(header.data(), header.size());
  if (file_.gcount() == 0) fail("ends without its last blocks: it was cut off");
  if (file_.gcount() != static_cast<std::streamsize>(block)) fail("is cut off");
  if (is_blank(header)) return std::nullopt;
  const auto found = read_header(header);
  if (!found) fail("is damaged: a header does not have its sum");
  TapeFile file{found->first, std::string(found->second, '\0')};
  file_.read(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
  if (file_.gcount() != static_cast<std::streamsize>(file.bytes.size())) fail("is cut off");
  file_.ignore(static_cast<std::streamsize>(padding(file.bytes.size())));
  return file;
}

std::vector<TapeFile> files_in(std::string_view blocks) {
  std::vector<TapeFile> files;
  while (!blocks.empty()) {
    Header header{};
    if (blocks.size() < block) throw UsageError("a sample is cut off");
    std::copy_n(blocks.begin(), block, header.begin());
    const auto found = read_header(header);
    if (!found || blocks.size() - block < found->second + padding(found->second))
      throw UsageError("a sample is damaged");
    files.push_back({found->first, std::string(blocks.substr(block, found->second))});
    blocks.remove_prefix(block + found->second + padding(found->second));
  }
  return files;
}

}  // namespace wuerfel
