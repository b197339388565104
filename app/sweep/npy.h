/// Arrays for NumPy: NPY files [NEP 1], and several of them in one NPZ file.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace wuerfel {

/// Doubles in C order; the product of `shape` is their number.
std::string npy_of(std::span<const double> values, const std::vector<std::size_t>& shape);
/// Whole numbers, 64 bits.
std::string npy_of(std::span<const std::int64_t> values);
/// Truth values.
std::string npy_of(const std::vector<bool>& values);
/// Texts, UTF-8 here and UCS-4 of one length there.
std::string npy_of(std::span<const std::string> values);

/// A zip archive without compression and without dates: what numpy.savez writes.
class NpzFile {
 public:
  /// At most 4 GB together. Throws UsageError beyond.
  void add(const std::string& name, const std::string& npy);
  /// All bytes of the archive.
  [[nodiscard]] std::string finish() const;

 private:
  std::string files_;
  std::string directory_;
  int count_ = 0;
};

}  // namespace wuerfel
