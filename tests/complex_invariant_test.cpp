// broken_invariant of a complex fails where a hull, the points or their number are wrong.
#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"
#include "kernel/tet_complex.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

std::vector<Point3> some_points() {
  const DistinctPoints distinct = distinct_points(point_sets::uniform_cube(40, 1));
  return {distinct.points.begin(), distinct.points.end()};
}

std::string complaint(LiftedHull hull, const std::vector<Point3>& points) {
  const TetComplex complex(std::move(hull), points.size());
  return broken_invariant(complex, points).value_or("sound");
}

/// Exchanges two corners of a tetrahedron together with its neighbours.
void exchange(LiftedHull& hull, std::uint32_t t, std::size_t a, std::size_t b) {
  std::swap(hull.tets[t][a], hull.tets[t][b]);
  std::swap(hull.neighbors[t][a], hull.neighbors[t][b]);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const FacetHandle h = hull.neighbors[t][i];
    hull.neighbors[h >> 2][h & 3] = 4 * t + i;
  }
}

/// Two hulls side by side, that of `second` with its vertices after those of `first`.
LiftedHull side_by_side(const LiftedHull& first, std::uint32_t first_vertices,
                        const LiftedHull& second) {
  const auto a = static_cast<std::uint32_t>(first.finite_count);
  const auto b = static_cast<std::uint32_t>(second.finite_count);
  const auto n = static_cast<std::uint32_t>(first.tets.size());
  LiftedHull both;
  both.finite_count = a + b;
  both.tets.resize(first.tets.size() + second.tets.size());
  both.neighbors.resize(both.tets.size());
  const auto add = [&](const LiftedHull& hull, std::uint32_t shift, auto&& place) {
    for (std::uint32_t t = 0; t < hull.tets.size(); ++t) {
      for (std::size_t i = 0; i < 4; ++i) {
        const VertexId v = hull.tets[t][i];
        const FacetHandle h = hull.neighbors[t][i];
        both.tets[place(t)][i] =
            v == kInfinite ? v : VertexId{static_cast<std::uint32_t>(v) + shift};
        both.neighbors[place(t)][i] = 4 * place(h >> 2) + (h & 3);
      }
    }
  };
  add(first, 0, [&](std::uint32_t t) { return t < a ? t : t + b; });
  add(second, first_vertices, [&](std::uint32_t t) { return t < b ? t + a : t + n; });
  return both;
}

TEST_CASE("sound complexes pass") {
  CHECK(complaint(lifted_hull(some_points()), some_points()) == "sound");
  CHECK(broken_invariant(TetComplex(), {}).value_or("sound") == "sound");
}

TEST_CASE("a tetrahedron turned inside out") {
  const std::vector<Point3> points = some_points();
  LiftedHull hull = lifted_hull(points);
  exchange(hull, 0, 2, 3);
  CHECK(complaint(std::move(hull), points) == "tetrahedron 0 is not positively oriented");
}

TEST_CASE("a tetrahedron with its corners in another order of the same orientation") {
  const std::vector<Point3> points = some_points();
  LiftedHull hull = lifted_hull(points);
  exchange(hull, 0, 0, 1);
  exchange(hull, 0, 2, 3);
  CHECK(complaint(std::move(hull), points) == "tetrahedron 0 has its corners out of order");
}

TEST_CASE("an infinite tetrahedron turned inside out") {
  const std::vector<Point3> points = some_points();
  LiftedHull hull = lifted_hull(points);
  exchange(hull, static_cast<std::uint32_t>(hull.finite_count), 2, 3);
  CHECK(complaint(std::move(hull), points).find("does not match its neighbour") !=
        std::string::npos);
}

TEST_CASE("a finite tetrahedron among the infinite ones") {
  const std::vector<Point3> points = some_points();
  LiftedHull hull = lifted_hull(points);
  --hull.finite_count;
  const std::string expected = "tetrahedron " + std::to_string(hull.finite_count);
  CHECK(complaint(std::move(hull), points) == expected + " has a wrong corner at infinity");
}

TEST_CASE("points that are not those of the hull") {
  const std::vector<Point3> points = some_points();
  std::vector<Point3> moved = points;
  std::swap(moved[3], moved[30]);
  CHECK(complaint(lifted_hull(points), moved).find("is not positively oriented") !=
        std::string::npos);
  const TetComplex complex(lifted_hull(points), points.size());
  moved.pop_back();
  CHECK(broken_invariant(complex, moved));
}

TEST_CASE("a vertex without a tetrahedron") {
  std::vector<Point3> points = some_points();
  LiftedHull hull = lifted_hull(points);
  points.push_back({2, 2, 2});
  CHECK(complaint(std::move(hull), points) == "vertex 40 is no corner of its tetrahedron");
}

TEST_CASE("two complexes instead of one") {
  const std::vector<Point3> points = some_points();
  const auto n = static_cast<std::uint32_t>(points.size());
  const LiftedHull hull = lifted_hull(points);
  const auto both = point_sets::joined(points, point_sets::translated(points, {5, 0, 0}));
  CHECK(complaint(side_by_side(hull, n, hull), both) == "Euler's relation gives 2 instead of 1");
}

}  // namespace
}  // namespace tetsculpt
