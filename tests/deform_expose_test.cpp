// Hidden vertices are brought to the surface wherever a single flip can do it, one flip each.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/circumspheres.h"
#include "sculpt/deform.h"
#include "sculpt/exposure.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

struct Scene {
  explicit Scene(const std::vector<Point3>& points)
      : s(testing::stages(points)), stars(s.complex), spheres(s.points(), s.complex) {}

  /// Checks on the way that the vertices returned are the hidden ones, and that all others that
  /// were took one flip each.
  Boundary exposed_from_hull() const {
    const Boundary hull(s.complex);
    Flags solid = hull.solid();
    const auto left = expose_hidden(s.complex, spheres, hull.hidden_vertices(), solid);
    std::size_t flips = 0;
    for (std::size_t t = 0; t < solid.size(); ++t) flips += solid[t] != hull.solid()[t];
    CHECK(flips == hull.hidden_count() - left.size());
    Boundary boundary(s.complex, solid);
    CHECK(boundary.hidden_vertices() == left);
    return boundary;
  }

  testing::Stages s;
  VertexStars stars;
  Circumspheres spheres;
};

/// The allowed flip that alone brings v out, of several the one with the least sphere; else none.
std::vector<TetId> flip_for(const Scene& scene, Boundary& boundary, VertexId v) {
  std::vector<TetId> best;
  for (const TetId t : scene.stars(v)) {
    if (!scene.s.complex.finite(t) || !exposure(boundary, t).removable) continue;
    boundary.flip(t);
    const bool out = boundary.on_boundary(v);
    boundary.flip(t);
    if (out && (best.empty() || scene.spheres.radius(t) < scene.spheres.radius(best[0]))) {
      best = {t};
    }
  }
  return best;
}

TEST_CASE("done twice, the second time changes nothing") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    const Scene scene(set.points);
    const Boundary boundary = scene.exposed_from_hull();
    Flags solid = boundary.solid();
    const auto hidden = boundary.hidden_vertices();
    CHECK(expose_hidden(scene.s.complex, scene.spheres, hidden, solid) == hidden);
    CHECK(solid == boundary.solid());
  }
}

TEST_CASE("one hidden vertex: the flip with the smallest sphere, and no other") {
  int seen = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    // The corners of a box about one point.
    std::vector<Point3> points{{0.2, 0.1, 0.15}};
    point_sets::Random random(seed);
    for (const Point3& p : point_sets::grid(2)) {
      points.push_back({2 * p.x - 1 + random.uniform(-0.1, 0.1),
                        2 * p.y - 1 + random.uniform(-0.1, 0.1),
                        2 * p.z - 1 + random.uniform(-0.1, 0.1)});
    }
    const Scene scene(points);
    Boundary boundary(scene.s.complex);
    REQUIRE(boundary.hidden_count() == 1);
    const auto expected = flip_for(scene, boundary, boundary.hidden_vertices()[0]);
    if (expected.empty()) continue;
    ++seen;
    boundary.flip(expected[0]);
    INFO("seed ", seed);
    REQUIRE(scene.exposed_from_hull().solid() == boundary.solid());
  }
  CHECK(seen > 100);
}

TEST_CASE("what stays hidden no single flip would bring out") {
  std::size_t hidden = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    for (const auto& points :
         {point_sets::clusters(10 + seed, seed), point_sets::uniform_cube(10 + seed, seed),
          point_sets::random_lattice(30, 4, seed)}) {
      const Scene scene(points);
      Boundary boundary = scene.exposed_from_hull();
      for (const VertexId v : boundary.hidden_vertices()) {
        INFO("seed ", seed, ", first point ", points[0].x, ", vertex ", +v);
        REQUIRE(flip_for(scene, boundary, v).empty());
        ++hidden;
      }
    }
  }
  MESSAGE("hidden vertices left: ", hidden);
  CHECK(hidden > 0);
}

}  // namespace
}  // namespace tetsculpt
