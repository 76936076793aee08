// Points of no surface at all: a closed manifold without degenerate triangles through every one.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/predicates.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

void check_surface(const std::vector<Point3>& points) {
  const Reconstruction result = reconstruct(points);
  const auto wrong = broken_invariant(result.mesh);
  CHECK_MESSAGE(!wrong, *wrong);
  const Topology t = topology(result.mesh);
  CHECK((t.closed && t.edge_manifold && t.vertex_manifold && t.oriented));
  const auto flat = [&](const std::array<std::uint32_t, 3>& c) {
    return collinear(result.mesh.points[c[0]], result.mesh.points[c[1]], result.mesh.points[c[2]]);
  };
  CHECK(std::ranges::none_of(result.mesh.triangles, flat));
  CHECK(std::ranges::count(testing::points_in_use(result.mesh), false) == 0);
  CHECK(testing::signed_volume(result.mesh) > 0);
  CHECK(result.hidden.size() == 0);
  CHECK(result.mesh.points.size() == result.counts.vertices);
}

TEST_CASE("uniform noise") {
  for (const std::size_t n : testing::some_of<std::size_t>({2000, 20000})) {
    INFO("box of ", n, ", seed 1");
    check_surface(point_sets::uniform_cube(n, 1));
  }
}

TEST_CASE("noise on a lattice, where many points share a sphere") {
  for (const std::size_t side : {8u, 14u, 20u}) {
    INFO("lattice of side ", side, ", seed 1");
    check_surface(point_sets::random_lattice(3000, side, 1));
  }
}

TEST_CASE("full grids") {
  for (const std::size_t side : {5u, 8u, 10u, 12u}) {
    INFO("grid of side ", side);
    check_surface(point_sets::grid(side));
  }
}

TEST_CASE("a ball with points all over its inside") {
  INFO("sphere of spacing 0.2, seed 1, and box of 300, seed 2");
  std::vector<Point3> inside = point_sets::uniform_cube(300, 2);
  inside = point_sets::translated(inside, {-0.5, -0.5, -0.5});
  check_surface(point_sets::joined(point_sets::sphere(0.2, 1), inside));
}

}  // namespace
}  // namespace tetsculpt
