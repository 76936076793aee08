// Rounds: N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", SoCG 2003. Hilbert
// index: J. Skilling, "Programming the Hilbert curve", AIP Conference Proceedings 707, 2004.
#include "kernel/spatial_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "kernel/large_array.h"
#include "kernel/radix_sort.h"

namespace tetsculpt {
namespace {

constexpr int kBitsPerAxis = 18;         // a cell of the curve is 2^-18 of the box
constexpr int kBitsPerRound = 1;         // a round is 2^1 - 1 times as large as all before it
constexpr std::size_t kFirstRound = 64;  // at most about so many points in the first round

/// A well mixed function of the id (the finaliser of SplitMix64).
std::uint64_t hash(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// Hilbert index of a cell: undo the excess work of the Gray code, axis by axis, then interleave.
std::uint64_t hilbert_index(std::array<std::uint32_t, 3> cell) {
  for (std::uint32_t bit = 1u << (kBitsPerAxis - 1); bit > 1; bit >>= 1) {
    const std::uint32_t below = bit - 1;
    for (std::uint32_t& axis : cell) {
      if (axis & bit) {
        cell[0] ^= below;
      } else {
        const std::uint32_t swapped = (cell[0] ^ axis) & below;
        cell[0] ^= swapped;
        axis ^= swapped;
      }
    }
  }
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t parity = 0;
  for (std::uint32_t bit = 1u << (kBitsPerAxis - 1); bit > 1; bit >>= 1) {
    if (cell[2] & bit) parity ^= bit - 1;
  }
  for (std::uint32_t& axis : cell) axis ^= parity;
  std::uint64_t index = 0;
  for (int b = kBitsPerAxis - 1; b >= 0; --b) {
    for (const std::uint32_t axis : cell) index = index << 1 | ((axis >> b) & 1);
  }
  return index;
}

/// Maps points to cells of a cube around all of them.
class Cells {
 public:
  explicit Cells(std::span<const Point3> points) : low_(points[0]) {
    Point3 high = points[0];
    for (const Point3& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double side = std::max({high.x - low_.x, high.y - low_.y, high.z - low_.z});
    cells_per_unit_ = side > 0 ? ((1 << kBitsPerAxis) - 1) / side : 0;
  }
  std::array<std::uint32_t, 3> operator()(const Point3& p) const {
    return {static_cast<std::uint32_t>((p.x - low_.x) * cells_per_unit_),
            static_cast<std::uint32_t>((p.y - low_.y) * cells_per_unit_),
            static_cast<std::uint32_t>((p.z - low_.z) * cells_per_unit_)};
  }

 private:
  Point3 low_;
  double cells_per_unit_;
};

}  // namespace

SpatialOrder spatial_order(std::span<const Point3> points) {
  SpatialOrder result;
  if (points.empty()) return result;
  std::uint64_t last_round = 0;
  while (points.size() >> (kBitsPerRound * last_round) > kFirstRound) ++last_round;

  const Cells cells(points);
  LargeArray<KeyedIndex> order(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    order[i] = {hilbert_index(cells(points[i])), static_cast<std::uint32_t>(i)};
  }
  radix_sort(order);
  result.place_on_curve.resize(points.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    result.place_on_curve[order[place].index] = static_cast<std::uint32_t>(place);
  }

  // Points are on the curve now: a stable sort by round leaves each round along it.
  std::vector<std::size_t> round_size(last_round + 1, 0);
  for (KeyedIndex& item : order) {
    const auto coins = static_cast<std::uint64_t>(std::countr_zero(hash(item.index)));
    item.key = last_round - std::min(coins / kBitsPerRound, last_round);
    ++round_size[item.key];
  }
  radix_sort(order);

  result.vertices.reserve(points.size());
  for (const KeyedIndex& item : order) result.vertices.push_back(VertexId{item.index});
  result.round_begin.push_back(0);
  for (const std::size_t size : round_size) {
    result.round_begin.push_back(result.round_begin.back() + size);
  }
  return result;
}

}  // namespace tetsculpt
