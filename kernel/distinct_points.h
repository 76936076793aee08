#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/point.h"

/// The entrance of the kernel: checks the input, merges equal points, and brings the coordinates
/// into the range in which the predicates are exact.
namespace tetsculpt {

/// A point that the kernel can't take: a NaN or infinite coordinate, or coordinates whose spread no
/// power of two brings into the exact range.
class InvalidPoint : public std::runtime_error {
 public:
  InvalidPoint(std::size_t index, const std::string& what)
      : std::runtime_error("point " + std::to_string(index) + ": " + what), index_(index) {}
  std::size_t index() const { return index_; }

 private:
  std::size_t index_;
};

/// The distinct points of a set, along a Hilbert curve (kernel/hilbert_order). Every later stage
/// works on `points` and numbers vertices by their place in it: no result depends on the order of
/// the input, and neighbours in space are neighbours in memory.
struct DistinctPoints {
  /// The input's coordinates times 2^scale_exponent, exactly.
  LargeArray<Point3> points;
  /// Per input point, its vertex.
  LargeArray<VertexId> vertex_of_input;
  /// Per vertex, the first input point with its coordinates.
  LargeArray<std::uint32_t> first_input;
  /// 0 unless the input lies outside the range of exact arithmetic.
  int scale_exponent = 0;
};

/// Coordinates must stay below 2^kMaxExponent and be multiples of 2^kMinExponent: the predicates'
/// polynomials of degree 6 then neither overflow nor lose a bit.
inline constexpr int kMaxExponent = 168;
inline constexpr int kMinExponent = -179;

/// Sorts and merges `points`. Throws InvalidPoint on a NaN or an infinity, and where the largest
/// coordinate and the lowest set bit are more than 347 binary orders apart; std::length_error above
/// 100 million points. Cost: one sort. The same on any number of threads.
DistinctPoints distinct_points(std::span<const Point3> points, int threads = 1);

/// The largest k such that all coordinates are multiples of 2^k; 0 if all are zero. Where a
/// polynomial's value is below 2^53 of its unit, double arithmetic is exact. None if the largest
/// coordinate and the lowest set bit are more than `most_bits` binary orders apart, which the first
/// few points mostly tell.
std::optional<int> unit_exponent(std::span<const Point3> points, int most_bits, int threads = 1);

std::optional<std::string> broken_invariant(const DistinctPoints& distinct,
                                            std::span<const Point3> input);

}  // namespace tetsculpt
