#include "render/files/huffman.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace wuerfel {
namespace {

/// Code lengths by the two-queue method: the leaves sorted by weight are one queue, the inner
/// nodes, which come up in order of weight, the other. Returns the longest.
int code_lengths(std::span<const std::uint32_t> weights,
                 const std::vector<std::size_t>& leaves,
                 std::vector<std::uint8_t>& lengths) {
  const std::size_t count = leaves.size();
  std::vector<std::uint64_t> weight(2 * count - 1);
  std::vector<std::size_t> parent(2 * count - 1, 0);
  for (std::size_t i = 0; i < count; ++i)
    weight[i] = weights[leaves[i]];
  std::size_t leaf = 0;
  std::size_t inner = count;
  for (std::size_t next = count; next < weight.size(); ++next) {
    const auto take_lightest = [&] {
      const bool from_leaves = inner >= next || (leaf < count && weight[leaf] <= weight[inner]);
      return from_leaves ? leaf++ : inner++;
    };
    const std::size_t a = take_lightest();
    const std::size_t b = take_lightest();
    weight[next] = weight[a] + weight[b];
    parent[a] = next;
    parent[b] = next;
  }
  std::vector<std::uint8_t> depth(weight.size(), 0);
  for (std::size_t i = weight.size() - 1; i-- > 0;) {
    depth[i] = static_cast<std::uint8_t>(depth[parent[i]] + 1);
  }
  for (std::size_t i = 0; i < count; ++i)
    lengths[leaves[i]] = depth[i];
  return *std::max_element(depth.begin(), depth.begin() + static_cast<std::ptrdiff_t>(count));
}

std::uint16_t reversed(unsigned code, int length) {
  unsigned result = 0;
  for (int i = 0; i < length; ++i)
    result |= ((code >> static_cast<unsigned>(i)) & 1U) << static_cast<unsigned>(length - 1 - i);
  return static_cast<std::uint16_t>(result);
}

/// Codes of equal length are consecutive numbers in the order of their symbols.
std::vector<std::uint16_t> canonical_bits(const std::vector<std::uint8_t>& lengths) {
  std::vector<std::uint16_t> bits(lengths.size(), 0);
  unsigned code = 0;
  for (int length = 1; length <= 15; ++length) {
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
      if (lengths[symbol] == length) bits[symbol] = reversed(code++, length);
    }
    code <<= 1U;
  }
  return bits;
}

}  // namespace

HuffmanCode huffman_code(std::span<const std::uint32_t> frequencies, int longest) {
  std::vector<std::uint32_t> weights(frequencies.begin(), frequencies.end());
  std::vector<std::size_t> leaves;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0) leaves.push_back(i);
  }
  HuffmanCode code;
  code.lengths.assign(weights.size(), 0);
  if (leaves.size() == 1) code.lengths[leaves.front()] = 1;
  if (leaves.size() > 1) {
    std::stable_sort(leaves.begin(), leaves.end(),
                     [&weights](std::size_t a, std::size_t b) { return weights[a] < weights[b]; });
    // Flatter weights give shorter codes; their order stays.
    while (code_lengths(weights, leaves, code.lengths) > longest) {
      for (std::uint32_t& weight : weights)
        weight = (weight + 1) / 2;
    }
  }
  code.bits = canonical_bits(code.lengths);
  return code;
}

}  // namespace wuerfel
