// The paper's method on sampled bodies: one closed manifold through every point, and the right
// genus where the method gives it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

constexpr double kPi = std::numbers::pi;

/// A surface without a fault, in one piece, through all points. Returns what came out.
Reconstruction faultless(const std::vector<Point3>& points) {
  Reconstruction result = testing::reconstruct_paper(points);
  REQUIRE(result.span == Span::kSolid);
  const auto wrong = broken_invariant(result.mesh);
  CHECK_MESSAGE(!wrong, *wrong);
  CHECK(result.hidden.empty());
  CHECK(result.mesh.points == points);
  CHECK(std::ranges::count(testing::points_in_use(result.mesh), false) == 0);
  const Topology t = topology(result.mesh);
  CHECK(t.components == 1);
  CHECK(t.genus == result.counts.holes);
  return result;
}

TEST_CASE("sphere") {
  for (const double spacing : {0.3, 0.2, 0.15}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      INFO("spacing ", spacing, ", seed ", seed);
      const auto result = faultless(point_sets::sphere(spacing, seed));
      CHECK(topology(result.mesh).genus == 0);
      const double full = 4 * kPi / 3;
      CHECK(testing::signed_volume(result.mesh) < full);
      CHECK(testing::signed_volume(result.mesh) > full * (1 - spacing * spacing));
    }
  }
}

TEST_CASE("ellipsoid") {
  for (const double spacing : {0.15, 0.1, 0.06}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      INFO("spacing ", spacing, ", seed ", seed);
      const auto result = faultless(point_sets::ellipsoid(spacing, seed));
      CHECK(topology(result.mesh).genus == 0);
      CHECK(testing::signed_volume(result.mesh) ==
            doctest::Approx(4 * kPi / 3 * 0.35).epsilon(4 * spacing * spacing));
    }
  }
}

TEST_CASE("cube, with its edges: all of its volume") {
  for (const double spacing : {0.15, 0.1, 0.06}) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      INFO("spacing ", spacing, ", seed ", seed);
      const auto result = faultless(point_sets::cube_surface(spacing, seed));
      CHECK(topology(result.mesh).genus == 0);
      CHECK(testing::signed_volume(result.mesh) == doctest::Approx(1));
    }
  }
}

TEST_CASE("torus: closed, manifold and open in the middle at any spacing and seed") {
  for (const double spacing : {0.2, 0.15, 0.12, 0.1}) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
      INFO("spacing ", spacing, ", seed ", seed);
      CHECK(topology(faultless(point_sets::torus(spacing, seed)).mesh).genus >= 1);
    }
  }
}

// Not at every spacing: the two fronts meet in a membrane that lies on the torus, and the method
// may take more than one pseudo-prism out of it.
TEST_CASE("torus: genus 1") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    INFO("spacing 0.15, seed ", seed);
    const auto result = faultless(point_sets::torus(0.15, seed));
    CHECK(topology(result.mesh).genus == 1);
    CHECK(testing::signed_volume(result.mesh) ==
          doctest::Approx(2 * kPi * kPi * 0.16).epsilon(0.08));
  }
}

TEST_CASE("double torus: two holes and perhaps more at any spacing and seed") {
  for (const double spacing : {0.12, 0.1, 0.08, 0.06}) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
      INFO("spacing ", spacing, ", seed ", seed);
      CHECK(topology(faultless(point_sets::double_torus(spacing, seed)).mesh).genus >= 2);
    }
  }
}

TEST_CASE("double torus: genus 2") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    INFO("spacing 0.12, seed ", seed);
    CHECK(topology(faultless(point_sets::double_torus(0.12, seed)).mesh).genus == 2);
  }
}

TEST_CASE("two bodies apart come out as one") {
  const auto ball = point_sets::sphere(0.3, 1);
  for (const double distance : {2.3, 3.0, 20.0}) {
    INFO("distance ", distance);
    faultless(point_sets::joined(ball, point_sets::translated(ball, {distance, 0.1, 0.2})));
  }
}

TEST_CASE("a cavity is filled: the paper's method has one shell") {
  const auto outer = point_sets::sphere(0.3, 1);
  faultless(point_sets::joined(outer, point_sets::scaled(point_sets::sphere(0.4, 2), 0.5)));
}

}  // namespace
}  // namespace tetsculpt
