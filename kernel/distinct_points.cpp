#include "kernel/distinct_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "kernel/hilbert_order.h"
#include "kernel/large_array.h"
#include "kernel/parallel.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kMaxPoints = 100'000'000;  // tetrahedra and their facets then have 32-bit ids

/// The binary range of a set of numbers: all are below 2^top and multiples of 2^unit.
struct BinaryRange {
  int top = std::numeric_limits<int>::min();
  int unit = std::numeric_limits<int>::max();
  std::size_t unit_at = 0;  ///< the point that holds the lowest set bit

  void include(double x, std::size_t point) {
    if (x == 0) return;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int field = static_cast<int>((bits >> 52) & 0x7ff);
    std::uint64_t mantissa = bits & ((1ull << 52) - 1);
    if (field != 0) mantissa |= 1ull << 52;
    const int lowest = std::max(field, 1) - 1075;
    top = std::max(top, lowest + static_cast<int>(std::bit_width(mantissa)));
    const int trailing = lowest + static_cast<int>(std::countr_zero(mantissa));
    if (trailing < unit) {
      unit = trailing;
      unit_at = point;
    }
  }
  /// Binary orders from the lowest bit to the highest.
  int span() const { return top > unit ? top - unit : 0; }
  /// That of points further on.
  void include(const BinaryRange& other) {
    top = std::max(top, other.top);
    if (other.unit < unit) {
      unit = other.unit;
      unit_at = other.unit_at;
    }
  }
};

/// May leave out points once the range spans more than `most` orders. Throws InvalidPoint at the
/// first that is not finite.
BinaryRange range_of(std::span<const Point3> points, int threads,
                     int most = std::numeric_limits<int>::max()) {
  const auto range_of_part = [&](std::size_t begin, std::size_t end) {
    BinaryRange range;
    for (std::size_t i = begin; i < end && range.span() <= most; ++i) {
      if (!finite(points[i])) throw InvalidPoint(i, "a coordinate is not a finite number");
      range.include(points[i].x, i);
      range.include(points[i].y, i);
      range.include(points[i].z, i);
    }
    return range;
  };
  BinaryRange range;
  const auto cuts = share_cuts(points.size(), threads);
  for (const auto& part : parallel_results(cuts, threads, range_of_part)) range.include(part);
  return range;
}

/// The power of two nearest to none that brings the range into the exact one.
int scale_exponent(const BinaryRange& range) {
  const int lowest = kMinExponent - range.unit;
  const int highest = kMaxExponent - range.top;
  if (lowest > highest) {
    throw InvalidPoint(range.unit_at,
                       "the coordinates of the set span " + std::to_string(range.top - range.unit) +
                           " binary orders of magnitude, more than the " +
                           std::to_string(kMaxExponent - kMinExponent) +
                           " in which arithmetic is exact; this point has the smallest digit");
  }
  return std::clamp(0, lowest, highest);
}

LargeArray<Point3> scaled(std::span<const Point3> points, int exponent) {
  LargeArray<Point3> result;
  result.reserve(points.size());
  for (const Point3& p : points) {
    result.push_back(
        {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)});
  }
  return result;
}

/// Sets points, with repetitions, and input points in the order of the curve. Whether any two
/// points are equal: those are neighbours there.
bool gather(std::span<const Point3> points, std::span<const std::uint32_t> order, int threads,
            DistinctPoints& result) {
  result.points.resize(points.size());
  result.first_input.resize(points.size());
  result.vertex_of_input.resize(points.size());  // set later, by threads all over it
  const auto gather_part = [&](std::size_t begin, std::size_t end) {
    touch(result.points, begin, end);
    touch(result.first_input, begin, end);
    touch(result.vertex_of_input, begin, end);
    bool any_equal = false;
    const Point3* last = begin > 0 ? &points[order[begin - 1]] : nullptr;
    for (std::size_t k = begin; k < end; ++k) {
      const Point3& p = points[order[k]];
      any_equal |= last && *last == p;
      last = &p;
      result.points[k] = p;
      result.first_input[k] = order[k];
    }
    return std::uint8_t{any_equal};  // not of a vector of bits: each thread writes its own
  };
  const auto any_equal = parallel_results(share_cuts(points.size(), threads), threads, gather_part);
  return std::ranges::find(any_equal, 1) != any_equal.end();
}

/// Keeps the first of equal points. Per place in the order, the point's vertex comes back.
LargeArray<std::uint32_t> merge_equal(DistinctPoints& result) {
  auto& points = result.points;
  LargeArray<std::uint32_t> vertex(points.size());
  std::uint32_t last = 0;
  vertex[0] = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (!(points[k] == points[last])) {
      ++last;
      points[last] = points[k];
      result.first_input[last] = result.first_input[k];
    }
    vertex[k] = last;
  }
  points.resize(last + 1);
  result.first_input.resize(last + 1);
  return vertex;
}

}  // namespace

DistinctPoints distinct_points(std::span<const Point3> points, int threads) {
  if (points.size() > kMaxPoints) throw std::length_error("more than 100 million points");
  const LargeArrayReuse reuse;
  DistinctPoints result;
  const BinaryRange range = range_of(points, threads);
  if (range.top > range.unit) result.scale_exponent = scale_exponent(range);
  LargeArray<Point3> in_range;
  if (result.scale_exponent != 0) {
    in_range = scaled(points, result.scale_exponent);
    points = in_range;
  }
  const LargeArray<std::uint32_t> order = hilbert_order(points, threads);
  LargeArray<std::uint32_t> vertex;  // per place in the order; empty if that is it
  if (gather(points, order, threads, result)) vertex = merge_equal(result);
  parallel_ranges(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      result.vertex_of_input[order[k]] =
          VertexId{vertex.empty() ? static_cast<std::uint32_t>(k) : vertex[k]};
    }
  });
  return result;
}

std::optional<int> unit_exponent(std::span<const Point3> points, int most_bits, int threads) {
  const BinaryRange range = range_of(points, threads, most_bits);
  if (range.span() > most_bits) return std::nullopt;
  return range.top > range.unit ? range.unit : 0;
}

std::optional<std::string> broken_invariant(const DistinctPoints& distinct,
                                            std::span<const Point3> input) {
  const auto& points = distinct.points;
  if (distinct.vertex_of_input.size() != input.size()) return "an input point has no vertex";
  if (distinct.first_input.size() != points.size()) return "a vertex has no input point";
  const LargeArray<std::uint32_t> order = hilbert_order(points);
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (order[v] != v) return "vertex " + std::to_string(v) + " is out of order";
    if (v > 0 && points[v - 1] == points[v]) {
      return "vertices " + std::to_string(v - 1) + " and " + std::to_string(v) + " are one point";
    }
    const std::size_t first = distinct.first_input[v];
    if (first >= input.size() || +distinct.vertex_of_input[first] != v) {
      return "vertex " + std::to_string(v) + " does not name an input point of its own";
    }
  }
  for (std::size_t i = 0; i < input.size(); ++i) {
    const std::size_t v = +distinct.vertex_of_input[i];
    if (v >= points.size()) return "input " + std::to_string(i) + " has a vertex out of range";
    const Point3& p = points[v];
    const int back = -distinct.scale_exponent;
    if (!(Point3{std::ldexp(p.x, back), std::ldexp(p.y, back), std::ldexp(p.z, back)} ==
          input[i])) {
      return "input " + std::to_string(i) + " is not its vertex";
    }
    if (distinct.first_input[v] > i) {
      return "vertex " + std::to_string(v) + " does not name its first input point";
    }
  }
  return std::nullopt;
}

}  // namespace tetsculpt
