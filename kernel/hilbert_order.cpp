// Hilbert index: J. Skilling, "Programming the Hilbert curve", AIP Conference Proceedings 707,
// 2004.
#include "kernel/hilbert_order.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tetsculpt {
namespace {

constexpr int kBitsPerAxis = 18;  // a cell of the curve is 2^-18 of the box

/// Puts two zeros before every bit.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x001f00000000ffff;
  x = (x | x << 16) & 0x001f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

/// Hilbert index of a cell: undo the excess work of the Gray code, axis by axis, then interleave.
/// Bits come without order: no branch depends on one, which takes half the time off.
std::uint64_t hilbert_index(std::array<std::uint32_t, 3> cell) {
  for (int b = kBitsPerAxis - 1; b > 0; --b) {
    const std::uint32_t below = (1u << b) - 1;
    for (std::uint32_t& axis : cell) {
      // Where the bit is set, invert; elsewhere exchange.
      const std::uint32_t inverted = (0u - (axis >> b & 1)) & below;
      const std::uint32_t swapped = (cell[0] ^ axis) & below & ~inverted;
      axis ^= swapped;
      cell[0] ^= swapped | inverted;
    }
  }
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t parity = cell[2] >> 1;  // of all higher bits, below
  for (int shift = 1; shift < kBitsPerAxis; shift *= 2) parity ^= parity >> shift;
  for (std::uint32_t& axis : cell) axis ^= parity;
  return spread(cell[0]) << 2 | spread(cell[1]) << 1 | spread(cell[2]);
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

/// Sorts each run of equal keys by the points themselves.
void sort_within_cells(std::span<const Point3> points, LargeArray<KeyedIndex>& order) {
  const auto less = [&](const KeyedIndex& a, const KeyedIndex& b) {
    const Point3& p = points[a.index];
    const Point3& q = points[b.index];
    return p == q ? a.index < b.index : lexicographically_less(p, q);
  };
  for (auto first = order.begin(); first != order.end();) {
    auto last = first + 1;
    while (last != order.end() && last->key == first->key) ++last;
    if (last - first > 1) std::sort(first, last, less);
    first = last;
  }
}

}  // namespace

LargeArray<KeyedIndex> hilbert_order(std::span<const Point3> points) {
  LargeArray<KeyedIndex> order(points.size());
  if (points.empty()) return order;
  const Cells cells(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    order[i] = {hilbert_index(cells(points[i])), static_cast<std::uint32_t>(i)};
  }
  radix_sort(order);
  sort_within_cells(points, order);
  return order;
}

}  // namespace tetsculpt
