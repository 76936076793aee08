// The guided method on samples of known bodies: closed, manifold, through all points, and the right
// topology.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

constexpr double kPi = std::numbers::pi;

/// A surface without a fault through all points. Returns it.
TriangleMesh faultless(const std::vector<Point3>& points) {
  const Reconstruction result = reconstruct(points);
  REQUIRE(result.span == Span::kSolid);
  const auto wrong = broken_invariant(result.mesh);
  CHECK_MESSAGE(!wrong, *wrong);
  CHECK(result.hidden.empty());
  CHECK(result.mesh.points == points);
  CHECK(std::ranges::count(testing::points_in_use(result.mesh), false) == 0);
  CHECK(result.counts.holes == 0);
  return result.mesh;
}

/// A faultless surface in one piece, of this genus, about this volume.
void check_body(const std::vector<Point3>& points, std::size_t genus, double volume,
                double tolerance) {
  const TriangleMesh mesh = faultless(points);
  const Topology t = topology(mesh);
  CHECK(t.components == 1);
  CHECK(t.genus == genus);
  CHECK(testing::signed_volume(mesh) == doctest::Approx(volume).epsilon(tolerance));
}

TEST_CASE("sphere") {
  for (const double spacing : {0.5, 0.3, 0.2, 0.1, 0.07}) {
    for (const std::uint64_t seed : testing::seeds(4)) {
      INFO("spacing ", spacing, ", seed ", seed);
      check_body(point_sets::sphere(spacing, seed), 0, 4 * kPi / 3, spacing * spacing);
    }
  }
}

TEST_CASE("ellipsoid") {
  for (const double spacing : {0.2, 0.15, 0.1, 0.06}) {
    for (const std::uint64_t seed : testing::seeds(4)) {
      INFO("spacing ", spacing, ", seed ", seed);
      check_body(point_sets::ellipsoid(spacing, seed), 0, 4 * kPi / 3 * 0.35,
                 4 * spacing * spacing);
    }
  }
}

TEST_CASE("cube, with its edges: all of its volume") {
  for (const double spacing : {0.15, 0.1, 0.06}) {
    for (const std::uint64_t seed : testing::seeds(4)) {
      INFO("spacing ", spacing, ", seed ", seed);
      check_body(point_sets::cube_surface(spacing, seed), 0, 1, 1e-9);
    }
  }
}

TEST_CASE("torus: genus 1") {
  for (const double spacing : {0.25, 0.2, 0.15, 0.12, 0.1, 0.07}) {
    for (const std::uint64_t seed : testing::seeds(4)) {
      INFO("spacing ", spacing, ", seed ", seed);
      check_body(point_sets::torus(spacing, seed), 1, 2 * kPi * kPi * 0.16, 4 * spacing * spacing);
    }
  }
}

TEST_CASE("double torus: genus 2") {
  // The limbs are 0.17 thick where they are thinnest.
  for (const double spacing : {0.11, 0.1, 0.08, 0.06}) {
    for (const std::uint64_t seed : testing::seeds(6)) {
      INFO("spacing ", spacing, ", seed ", seed);
      const Topology t = topology(faultless(point_sets::double_torus(spacing, seed)));
      CHECK(t.components == 1);
      CHECK(t.genus == 2);
    }
  }
}

TEST_CASE("samples at random, not evenly spread: still a torus, still a ball") {
  for (const std::uint64_t seed : testing::seeds(4)) {
    INFO("seed ", seed);
    const Topology torus = topology(faultless(point_sets::random_torus(5000, seed)));
    CHECK(torus.components == 1);
    CHECK(torus.genus == 1);
    const Topology ball = topology(faultless(point_sets::bumpy_sphere(2000, seed)));
    CHECK(ball.components == 1);
    CHECK(ball.genus == 0);
  }
}

}  // namespace
}  // namespace tetsculpt
