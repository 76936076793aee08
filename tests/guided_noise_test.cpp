// Points of no surface at all: the invariants hold, and hardly a point stays hidden.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

/// Returns how many points are hidden.
std::size_t check_invariants(const std::vector<Point3>& points) {
  const Reconstruction result = reconstruct(points);
  const auto wrong = broken_invariant(result.mesh);
  CHECK_MESSAGE(!wrong, *wrong);
  const Topology t = topology(result.mesh);
  CHECK((t.closed && t.edge_manifold && t.vertex_manifold && t.oriented));
  CHECK(std::ranges::count(testing::points_in_use(result.mesh), false) == 0);
  CHECK(testing::signed_volume(result.mesh) > 0);
  CHECK(result.mesh.points.size() + result.hidden.size() == result.counts.vertices);
  return result.hidden.size();
}

TEST_CASE("uniform noise") {
  for (const std::size_t n : {2000u, 20000u}) {
    INFO("box of ", n, ", seed 1");
    const std::size_t hidden = check_invariants(point_sets::uniform_cube(n, 1));
    MESSAGE(hidden, " points of ", n, " hidden");
    CHECK(1000 * hidden <= n);
  }
}

TEST_CASE("noise on a lattice, where many points share a sphere") {
  for (const std::size_t side : {8u, 14u, 20u}) {
    INFO("lattice of side ", side, ", seed 1");
    const std::size_t hidden = check_invariants(point_sets::random_lattice(3000, side, 1));
    MESSAGE(hidden, " points hidden, lattice of side ", side);
    CHECK(hidden <= 3);
  }
}

TEST_CASE("a full grid, and a ball with points all over its inside") {
  CHECK(check_invariants(point_sets::grid(10)) <= 3);
  std::vector<Point3> inside = point_sets::uniform_cube(300, 2);
  inside = point_sets::translated(inside, {-0.5, -0.5, -0.5});
  CHECK(check_invariants(point_sets::joined(point_sets::sphere(0.2, 1), inside)) <= 3);
}

}  // namespace
}  // namespace tetsculpt
