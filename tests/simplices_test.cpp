// Triangles and edges are numbered the same whoever finds them; those of a hull with wrong links,
// too, and under sanitizers nothing else is written to.
#include "kernel/simplices.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using point_sets::NamedPoints;

/// Large enough for several threads.
std::vector<NamedPoints> sets() {
  return {{"cube", point_sets::uniform_cube(6000, 1)},
          {"bumpy sphere", point_sets::bumpy_sphere(6000, 2)},
          {"grid", point_sets::grid(16)},
          {"skew lines", point_sets::skew_lines(150)},
          {"lattice sphere", point_sets::lattice_sphere(100001)},
          {"clusters", point_sets::clusters(5000, 3)}};
}

LiftedHull hull_of(const std::vector<Point3>& points) {
  return lifted_hull(distinct_points(points).points);
}

bool same(const Simplices& a, const Simplices& b) {
  const auto same_edge = [](const Simplices::Edge& p, const Simplices::Edge& q) {
    return p.vertices == q.vertices && p.triangle == q.triangle;
  };
  return a.triangles_of_tet == b.triangles_of_tet && a.edges_of_tet == b.edges_of_tet &&
         a.facet_of_triangle == b.facet_of_triangle &&
         std::ranges::equal(a.edges, b.edges, same_edge);
}

TEST_CASE("the same with and without vectors, on any number of threads") {
  for (const NamedPoints& set : sets()) {
    CAPTURE(set.name);
    const LiftedHull hull = hull_of(set.points);
    REQUIRE(hull.finite_count > 16384);  // worth four threads
    const Simplices plain = find_simplices(hull, {.by_eight = false});
    for (const int threads : {1, 2, 3, 4}) {
      CAPTURE(threads);
      CHECK(same(find_simplices(hull, {.threads = threads}), plain));
      CHECK(same(find_simplices(hull, {.threads = threads, .by_eight = false}), plain));
    }
  }
}

TEST_CASE("small hulls") {
  for (std::size_t n = 4; n < 40; ++n) {
    CAPTURE(n);
    const LiftedHull hull = hull_of(point_sets::uniform_cube(n, n));
    const Simplices simplices = find_simplices(hull);
    CHECK(same(simplices, find_simplices(hull, {.by_eight = false})));
    const auto euler = static_cast<std::int64_t>(n + simplices.facet_of_triangle.size()) -
                       static_cast<std::int64_t>(simplices.edges.size() + hull.finite_count);
    CHECK(euler == 1);
  }
}

TEST_CASE("of a hull with wrong links what comes out is wrong in one way") {
  LiftedHull hull = hull_of(point_sets::uniform_cube(3000, 4));
  point_sets::Random random(5);
  for (int k = 0; k < 3000; ++k) {
    const std::size_t t = random.below(hull.finite_count);
    hull.neighbors[t][random.below(4)] =
        static_cast<FacetHandle>(random.below(4 * hull.tets.size()));
  }
  const Simplices plain = find_simplices(hull, {.by_eight = false});
  CHECK(same(find_simplices(hull), plain));
  for (const int threads : {2, 3, 4}) {
    CAPTURE(threads);
    const Simplices shared = find_simplices(hull, {.threads = threads});
    CHECK(same(find_simplices(hull, {.threads = threads, .by_eight = false}), shared));
    // What is handed on across a cut in the wrong way may leave a facet without its triangle.
    CHECK(shared.facet_of_triangle == plain.facet_of_triangle);
    CHECK(shared.edges_of_tet == plain.edges_of_tet);
  }
}

}  // namespace
}  // namespace tetsculpt
