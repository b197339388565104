/// Values as bytes and back: one function that names the members of a type serves both ways.
#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/geometry/vec2.h"
#include "core/time/restart_point.h"

namespace wuerfel {

template <typename T>
concept Plain = (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) || std::is_enum_v<T>;

class ArchiveWriter {
 public:
  template <Plain T>
  void operator()(T& value) {
    const auto* at = reinterpret_cast<const char*>(&value);
    bytes_.append(at, sizeof value);
  }
  void operator()(bool& value) { bytes_ += value ? '\1' : '\0'; }
  void operator()(std::string& text) {
    std::uint64_t size = text.size();
    (*this)(size);
    bytes_ += text;
  }
  /// The number of elements, to be written before them.
  std::size_t count(std::size_t size) {
    std::uint64_t number = size;
    (*this)(number);
    return size;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Throws RestartError where the bytes end too early.
class ArchiveReader {
 public:
  explicit ArchiveReader(std::string_view bytes) : rest_(bytes) {}

  template <Plain T>
  void operator()(T& value) {
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
  }
  void operator()(bool& value) { value = take(1).front() != '\0'; }
  void operator()(std::string& text) {
    std::uint64_t size = 0;
    (*this)(size);
    text = take(size);
  }
  /// The number of elements that were written. Each has at least one byte.
  std::size_t count(std::size_t) {
    std::uint64_t number = 0;
    (*this)(number);
    if (number > rest_.size()) throw RestartError("it ends too early");
    return number;
  }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) throw RestartError("it ends too early");
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest_;
};

template <class Archive, typename T>
requires std::invocable<Archive&, T&>
void transfer(Archive& archive, T& value) { archive(value); }

/// Several values, one after the other.
template <class Archive, typename... T>
void transfer_all(Archive& archive, T&... values) {
  (transfer(archive, values), ...);
}

template <class Archive>
void transfer(Archive& archive, Vec2& v) {
  transfer_all(archive, v.x(), v.y());
}

template <class Archive>
void transfer(Archive& archive, BodyState& s) {
  transfer_all(archive, s.position, s.angle, s.velocity, s.spin);
}

template <class Archive, typename T>
void transfer(Archive& archive, std::vector<T>& list) {
  list.resize(archive.count(list.size()));
  for (T& element : list)
    transfer(archive, element);
}

}  // namespace wuerfel
