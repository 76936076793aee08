// On well-sampled surfaces the poles are near the medial axis, one on either side, along the
// normal.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/large_array.h"
#include "sculpt/circumspheres.h"
#include "sculpt/poles.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using Vec = Vec3<double>;

struct Scene {
  explicit Scene(const std::vector<Point3>& points)
      : s(testing::stages(points)),
        spheres(s.points(), s.complex),
        pairs(poles(s.points(), s.complex, spheres)) {}

  testing::Stages s;
  Circumspheres spheres;
  LargeArray<PolePair> pairs;
};

Vec unit(const Vec& a) { return a * (1 / length(a)); }

/// Outward normal of the torus with radii 1 and 0.4.
Vec torus_normal(const Point3& p) {
  const double ring = std::hypot(p.x, p.y);
  return unit({p.x - p.x / ring, p.y - p.y / ring, p.z});
}

/// Negative inside the tube.
double torus_side(const Vec& p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4; }

TEST_CASE("sphere: one pole at infinity, the other in the middle") {
  for (const double spacing : {0.3, 0.2, 0.1}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const Scene scene(point_sets::sphere(spacing, seed));
      for (std::size_t v = 0; v < scene.pairs.size(); ++v) {
        INFO("spacing ", spacing, ", seed ", seed, ", vertex ", v);
        const PolePair& pair = scene.pairs[v];
        REQUIRE_FALSE(scene.s.complex.finite(pair.first));
        REQUIRE(scene.s.complex.finite(pair.second));
        // Points are on the sphere to 1e-11 only: that moves the centres of thin tetrahedra.
        REQUIRE(length(scene.spheres.centre(pair.second)) < spacing);
        REQUIRE(dot(pair.axis, as_vector(scene.s.points()[v])) > std::cos(spacing));
        REQUIRE(pair.strength > std::cos(spacing));
      }
    }
  }
}

TEST_CASE("torus: one pole in the tube, the other not, both along the normal") {
  for (const double spacing : {0.1, 0.07}) {
    for (const std::uint64_t seed : {1u, 2u}) {
      const Scene scene(point_sets::torus(spacing, seed));
      std::size_t finite = 0;
      for (std::size_t v = 0; v < scene.pairs.size(); ++v) {
        INFO("spacing ", spacing, ", seed ", seed, ", vertex ", v);
        const PolePair& pair = scene.pairs[v];
        const Vec normal = torus_normal(scene.s.points()[v]);
        REQUIRE(std::fabs(dot(pair.axis, normal)) > 0.8);
        REQUIRE(pair.strength > 0.8);
        const bool out = dot(pair.axis, normal) > 0;
        const double second = torus_side(scene.spheres.centre(pair.second));
        REQUIRE((second > 0) != out);
        if (!scene.s.complex.finite(pair.first)) continue;
        ++finite;
        REQUIRE((torus_side(scene.spheres.centre(pair.first)) > 0) == out);
      }
      CHECK(5 * finite > scene.pairs.size());  // all around the hole
    }
  }
}

TEST_CASE("a ball in a ball: poles of the inner one in its middle and in between") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const auto inner = point_sets::scaled(point_sets::sphere(0.2, seed), 0.5);
    const Scene scene(point_sets::joined(point_sets::sphere(0.1, seed), inner));
    for (std::size_t v = 0; v < scene.pairs.size(); ++v) {
      const Vec p = as_vector(scene.s.points()[v]);
      if (length(p) > 0.75) continue;
      INFO("seed ", seed, ", vertex ", v);
      const PolePair& pair = scene.pairs[v];
      double near = length(scene.spheres.centre(pair.first));
      double far = length(scene.spheres.centre(pair.second));
      if (near > far) std::swap(near, far);
      REQUIRE(near < 0.05);
      REQUIRE(far == doctest::Approx(0.75).epsilon(0.1));
      REQUIRE(std::fabs(dot(pair.axis, unit(p))) > 0.9);
      REQUIRE(pair.strength > 0.7);
    }
  }
}

}  // namespace
}  // namespace tetsculpt
