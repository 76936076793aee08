// The hull is the same whether facets are taken one after the other or four at a time.
#include <doctest/doctest.h>

#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

TEST_CASE("the same hull") {
  for (const std::vector<Point3>& set :
       {point_sets::uniform_cube(5000, 1), point_sets::bumpy_sphere(5000, 2),
        point_sets::random_lattice(3000, 12, 3), point_sets::grid(12),
        point_sets::clusters(3000, 4), point_sets::skew_lines(300)}) {
    const LargeArray<Point3> points = distinct_points(set).points;
    const LiftedHull four = lifted_hull(points);
    const LiftedHull one = lifted_hull(points, {.four_lanes = false});
    CHECK(one.finite_count == four.finite_count);
    CHECK((one.tets == four.tets));
    CHECK((one.neighbors == four.neighbors));
  }
}

}  // namespace
}  // namespace tetsculpt
