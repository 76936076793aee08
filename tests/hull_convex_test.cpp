// No point lies beyond a triangle of the convex hull.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"
#include "kernel/predicates.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

/// An infinite facet with `p` in the place of infinity is positively oriented if p lies beyond it.
Sign side(std::span<const Point3> points, const std::array<VertexId, 4>& facet, const Point3& p) {
  std::array<Point3, 4> c;
  for (std::size_t i = 0; i < 4; ++i) c[i] = facet[i] == kInfinite ? p : points[+facet[i]];
  return orient3d(c[0], c[1], c[2], c[3]);
}

void check_convex(const std::vector<Point3>& input) {
  const LargeArray<Point3> points = distinct_points(input).points;
  const LiftedHull hull = lifted_hull(points);
  std::size_t beyond = 0;
  std::size_t without_inner_point = 0;
  for (std::size_t t = hull.finite_count; t < hull.tets.size(); ++t) {
    std::size_t inner = 0;
    for (const Point3& p : points) {
      const Sign s = side(points, hull.tets[t], p);
      beyond += s == Sign::kPositive;
      inner += s == Sign::kNegative;
    }
    without_inner_point += inner == 0;
  }
  CHECK(hull.tets.size() > hull.finite_count);
  CHECK(beyond == 0);
  CHECK(without_inner_point == 0);
}

TEST_CASE("small and middling solids") {
  for (const auto& set : oracle::small_solids()) {
    CAPTURE(set.name);
    check_convex(set.points);
  }
  for (const auto& set : oracle::middling_solids()) {
    CAPTURE(set.name);
    check_convex(set.points);
  }
}

TEST_CASE("all points on the hull: a random sphere") { check_convex(point_sets::sphere(0.12, 1)); }

TEST_CASE("a grid's hull keeps every lattice point of its six sides") {
  for (const std::size_t side : {2u, 3u, 6u}) {
    CAPTURE(side);
    const std::vector<Point3> points = point_sets::grid(side);
    const LiftedHull hull = lifted_hull(points);
    CHECK(hull.tets.size() - hull.finite_count == 12 * (side - 1) * (side - 1));
  }
}

}  // namespace
}  // namespace tetsculpt
