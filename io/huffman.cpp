// D. A. Huffman, A method for the construction of minimum-redundancy codes, 1952. The limit on the
// lengths is kept by flattening the counts and building again; pictures hardly ever need that.
#include "io/huffman.h"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

namespace tetsculpt {
namespace {

constexpr std::size_t kLongest = 15;

// The unlimited code. The nodes of the tree are the symbols and, behind them, the inner nodes in
// the order of their making: a parent has a greater number than its children.
std::vector<std::size_t> depths(std::span<const std::uint32_t> counts) {
  using Weighted = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Weighted, std::vector<Weighted>, std::greater<>> roots;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) roots.emplace(counts[i], i);
  }
  std::vector<std::size_t> parent(counts.size());
  std::vector<std::size_t> depth(counts.size());
  if (roots.size() == 1) depth[roots.top().second] = 1;
  if (roots.size() < 2) return depth;
  while (roots.size() > 1) {
    const Weighted a = roots.top();
    roots.pop();
    const Weighted b = roots.top();
    roots.pop();
    parent[a.second] = parent[b.second] = parent.size();
    roots.emplace(a.first + b.first, parent.size());
    parent.push_back(0);
  }
  depth.resize(parent.size());
  for (std::size_t i = parent.size() - 1; i-- > 0;) {
    if (i >= counts.size() || counts[i] > 0) depth[i] = depth[parent[i]] + 1;
  }
  depth.resize(counts.size());
  return depth;
}

std::uint16_t reversed(unsigned code, std::size_t length) {
  unsigned result = 0;
  for (std::size_t i = 0; i < length; ++i, code >>= 1) result = result << 1 | (code & 1);
  return static_cast<std::uint16_t>(result);
}

}  // namespace

std::vector<std::uint8_t> code_lengths(std::span<const std::uint32_t> counts, int limit) {
  std::vector<std::uint32_t> flattened(counts.begin(), counts.end());
  std::vector<std::size_t> depth = depths(flattened);
  while (!depth.empty() && *std::ranges::max_element(depth) > static_cast<std::size_t>(limit)) {
    for (std::uint32_t& count : flattened) count = (count + 1) / 2;  // in the end, all are 1
    depth = depths(flattened);
  }
  std::vector<std::uint8_t> lengths;
  for (const std::size_t d : depth) lengths.push_back(static_cast<std::uint8_t>(d));
  return lengths;
}

std::vector<std::uint16_t> canonical_codes(std::span<const std::uint8_t> lengths) {
  std::array<unsigned, kLongest + 1> occurrences{};
  for (const std::uint8_t length : lengths) ++occurrences[length];
  occurrences[0] = 0;
  std::array<unsigned, kLongest + 1> next{};
  for (std::size_t length = 1; length <= kLongest; ++length) {
    next[length] = (next[length - 1] + occurrences[length - 1]) << 1;
  }
  std::vector<std::uint16_t> codes;
  for (const std::uint8_t length : lengths) codes.push_back(reversed(next[length]++, length));
  return codes;
}

}  // namespace tetsculpt
