// The lifted hull is a closed complex: finite facets first, neighbours mutual, each triangle in two
// facets with opposite orientations, and every point a corner of a finite facet.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"
#include "kernel/predicates.h"
#include "tests/support/graph_oracles.h"

namespace tetsculpt {
namespace {

using Corners = std::array<VertexId, 4>;

/// The facet opposite corner i, its corners sorted, and the parity of their order there.
struct OrientedFacet {
  std::array<VertexId, 3> corners;
  bool odd;
};

OrientedFacet facet(const Corners& tet, std::size_t i) {
  OrientedFacet f{{tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4]}, i % 2 == 1};
  for (const auto& [a, b] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 1}}) {
    auto& x = f.corners[static_cast<std::size_t>(a)];
    auto& y = f.corners[static_cast<std::size_t>(b)];
    if (y < x) std::swap(x, y), f.odd = !f.odd;
  }
  return f;
}

std::size_t unmatched_facets(const LiftedHull& hull) {
  std::size_t wrong = 0;
  for (std::size_t t = 0; t < hull.tets.size(); ++t) {
    for (std::size_t i = 0; i < 4; ++i) {
      const FacetHandle h = hull.neighbors[t][i];
      REQUIRE(h / 4 < hull.tets.size());
      const OrientedFacet mine = facet(hull.tets[t], i);
      const OrientedFacet other = facet(hull.tets[h / 4], h % 4);
      wrong += h / 4 == t || hull.neighbors[h / 4][h % 4] != 4 * t + i;
      wrong += mine.corners != other.corners || mine.odd == other.odd;
    }
  }
  return wrong;
}

std::size_t misplaced_facets(const LiftedHull& hull, std::span<const Point3> points) {
  std::size_t wrong = 0;
  for (std::size_t t = 0; t < hull.tets.size(); ++t) {
    const Corners& c = hull.tets[t];
    const auto infinite = std::count(c.begin(), c.end(), kInfinite);
    wrong += infinite != (t < hull.finite_count ? 0 : 1);
    if (t >= hull.finite_count) continue;
    wrong +=
        orient3d(points[+c[0]], points[+c[1]], points[+c[2]], points[+c[3]]) != Sign::kPositive;
  }
  return wrong;
}

std::size_t unused_points(const LiftedHull& hull, std::size_t n) {
  std::vector<bool> used(n, false);
  for (std::size_t t = 0; t < hull.finite_count; ++t) {
    for (const VertexId v : hull.tets[t]) used[+v] = true;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

/// Corners are in ascending order, infinity after all others, but for the last two.
std::size_t unordered_facets(const LiftedHull& hull) {
  return static_cast<std::size_t>(std::ranges::count_if(
      hull.tets, [](const Corners& c) { return !(c[0] < c[1] && c[1] < std::min(c[2], c[3])); }));
}

/// The infinite facets close a sphere: Euler's relation on their triangles.
bool hull_is_a_sphere(const LiftedHull& hull) {
  std::map<VertexId, int> vertices;
  for (std::size_t t = hull.finite_count; t < hull.tets.size(); ++t) {
    for (const VertexId v : hull.tets[t]) ++vertices[v];
  }
  vertices.erase(kInfinite);
  return hull.tets.size() - hull.finite_count == 2 * vertices.size() - 4;
}

TEST_CASE("small and middling solids") {
  auto sets = oracle::small_solids();
  const auto more = oracle::middling_solids();
  sets.insert(sets.end(), more.begin(), more.end());
  for (const auto& set : sets) {
    CAPTURE(set.name);
    const LargeArray<Point3> points = distinct_points(set.points).points;
    const LiftedHull hull = lifted_hull(points);
    CHECK(hull.finite_count > 0);
    CHECK(hull.neighbors.size() == hull.tets.size());
    CHECK(unmatched_facets(hull) == 0);
    CHECK(misplaced_facets(hull, points) == 0);
    CHECK(unordered_facets(hull) == 0);
    CHECK(unused_points(hull, points.size()) == 0);
    CHECK(hull_is_a_sphere(hull));
  }
}

TEST_CASE("flat sets have no facet") {
  for (const auto& set : oracle::flat_sets()) {
    CAPTURE(set.name);
    const LiftedHull hull = lifted_hull(distinct_points(set.points).points);
    CHECK(hull.tets.empty());
    CHECK(hull.neighbors.empty());
    CHECK(hull.finite_count == 0);
  }
}

}  // namespace
}  // namespace tetsculpt
