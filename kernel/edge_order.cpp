#include "kernel/edge_order.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <optional>

#include "kernel/distinct_points.h"
#include "kernel/large_array.h"
#include "kernel/predicates.h"
#include "kernel/radix_sort.h"

namespace tetsculpt {
namespace {

/// Squared length, off by at most 5 roundings: differences twice, square, two sums.
double squared_length(const Point3& a, const Point3& b) {
  const double x = b.x - a.x;
  const double y = b.y - a.y;
  const double z = b.z - a.z;
  return x * x + y * y + z * z;
}

}  // namespace

std::vector<EdgeId> edges_by_length(std::span<const Point3> points, const TetComplex& complex,
                                    const Flags& chosen) {
  LargeArray<KeyedIndex> items;
  items.reserve(static_cast<std::size_t>(std::count(chosen.begin(), chosen.end(), 1)));
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    if (!chosen[e]) continue;
    const auto [a, b] = complex.vertices(EdgeId{e});
    items.push_back({std::bit_cast<std::uint64_t>(squared_length(points[+a], points[+b])), e});
  }
  radix_sort(items);

  // Below this all arithmetic on squared lengths is exact, because they are multiples of the
  // unit's.
  constexpr int kMostBits = 48;  // of smaller units few lengths are below
  const std::optional<int> unit = unit_exponent(points, kMostBits);
  const double exact_below = unit ? std::ldexp(1.0, 53 + 2 * *unit) : 0;
  const auto shorter = [&](const KeyedIndex& p, const KeyedIndex& q) {
    const double pp = std::bit_cast<double>(p.key);
    const double qq = std::bit_cast<double>(q.key);
    const auto [a, b] = complex.vertices(EdgeId{p.index});
    const auto [c, d] = complex.vertices(EdgeId{q.index});
    const Sign s = std::max(pp, qq) < exact_below
                       ? sign_of(pp - qq)
                       : compare_lengths(points[+a], points[+b], points[+c], points[+d]);
    if (s != Sign::kZero) return s == Sign::kNegative;
    return a != c ? a < c : b < d;
  };
  // Two rounded values can be in the wrong order only if they are within 11 roundings.
  const double near = 1 + 11 * DBL_EPSILON;
  for (auto first = items.begin(); first != items.end();) {
    auto last = first + 1;
    while (last != items.end() &&
           std::bit_cast<double>(last->key) <= near * std::bit_cast<double>((last - 1)->key)) {
      ++last;
    }
    if (last - first > 1) std::sort(first, last, shorter);
    first = last;
  }

  std::vector<EdgeId> order;
  order.reserve(items.size());
  for (const KeyedIndex& item : items) order.push_back(EdgeId{item.index});
  return order;
}

}  // namespace tetsculpt
