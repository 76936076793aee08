// A walk that succeeds brings out its one vertex and keeps the topology of the surface; one that
// fails leaves no trace.
#include "sculpt/flip_walk.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/triangle_mesh.h"
#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/circumspheres.h"
#include "sculpt/deform.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

std::vector<testing::NamedSet> crowded_sets() {
  std::vector<testing::NamedSet> sets;
  for (const std::size_t side : {4u, 5u, 6u}) {
    sets.push_back({"grid of side " + std::to_string(side), point_sets::grid(side)});
  }
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::string s = ", seed " + std::to_string(seed);
    sets.push_back({"box of 150" + s, point_sets::uniform_cube(150, seed)});
    sets.push_back({"clusters of 100" + s, point_sets::clusters(100, seed)});
    sets.push_back({"lattice of side 6" + s, point_sets::random_lattice(150, 6, seed)});
  }
  return sets;
}

struct Scene {
  explicit Scene(const std::vector<Point3>& points)
      : s(testing::stages(points)), stars(s.complex) {}

  /// The hull, moved as far as single flips bring out hidden vertices.
  Boundary exposed_from_hull() const {
    const Boundary hull(s.complex);
    Flags solid = hull.solid();
    const Circumspheres spheres(s.points(), s.complex);
    expose_hidden(s.complex, spheres, hull.hidden_vertices(), solid);
    return Boundary(s.complex, solid);
  }
  testing::Stages s;
  VertexStars stars;
};

struct Outcomes {
  int out = 0;
  int failed = 0;
};

/// Walks for each hidden vertex once, and checks what that did.
void walk_for_all(const Scene& scene, Boundary& boundary, std::size_t steps, Outcomes& outcomes) {
  for (const VertexId v : boundary.hidden_vertices()) {
    INFO("vertex ", +v, ", steps ", steps);
    const Flags before = boundary.solid();
    const auto hidden = boundary.hidden_vertices();
    const std::int64_t characteristic = boundary.euler_characteristic();
    if (boundary.on_boundary(v)) continue;
    if (!expose_by_walk(boundary, scene.stars, v, steps)) {
      REQUIRE(boundary.solid() == before);
      ++outcomes.failed;
      continue;
    }
    ++outcomes.out;
    REQUIRE(boundary.on_boundary(v));
    REQUIRE(boundary.hidden_count() < hidden.size());
    REQUIRE(boundary.euler_characteristic() == characteristic);
    REQUIRE(scene.s.all_stars_good(scene.stars, boundary.solid()));
    const Topology t = topology(scene.s.surface(boundary.solid()));
    REQUIRE((t.closed && t.edge_manifold && t.vertex_manifold && t.oriented));
    REQUIRE(t.components == 1);
    REQUIRE(t.genus == 0);
  }
  const auto wrong = broken_invariant(boundary);
  REQUIRE_MESSAGE(!wrong, *wrong);
}

TEST_CASE("from the hull, where single flips are stuck") {
  Outcomes too_short, outcomes;
  for (const testing::NamedSet& set : crowded_sets()) {
    INFO(set);
    const Scene scene(set.points);
    Boundary boundary = scene.exposed_from_hull();
    walk_for_all(scene, boundary, 0, too_short);
    CHECK(too_short.out == 0);
    for (const std::size_t steps : {1u, 3u, 30u, 1000u}) {
      walk_for_all(scene, boundary, steps, outcomes);
    }
  }
  MESSAGE(outcomes.out, " vertices brought out, ", outcomes.failed, " walks in vain");
  CHECK(too_short.failed > 100);
  CHECK(outcomes.out > 100);
  CHECK(outcomes.failed > 100);
}

TEST_CASE("the same walk twice ends on the same surface") {
  for (const testing::NamedSet& set : crowded_sets()) {
    INFO(set);
    const Scene scene(set.points);
    Boundary once = scene.exposed_from_hull();
    Boundary twice = once;
    for (const VertexId v : once.hidden_vertices()) {
      const bool out = expose_by_walk(once, scene.stars, v, 100);
      REQUIRE(expose_by_walk(twice, scene.stars, v, 100) == out);
      REQUIRE(once.solid() == twice.solid());
    }
  }
}

}  // namespace
}  // namespace tetsculpt
