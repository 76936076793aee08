// Hilbert index: J. Skilling, "Programming the Hilbert curve", AIP Conference Proceedings 707,
// 2004.
#include "kernel/hilbert_order.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tetsculpt {
namespace {

constexpr int kBitsPerAxis = 18;  // a cell of the curve is 2^-18 of the box

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
