// Several shells: bodies apart, cavities, bodies in cavities, and linked rings. Every shell looks
// outward from the solid: one in a cavity is counterclockwise from outside, a cavity the other way.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <vector>

#include "kernel/disjoint_sets.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kBall = 4 * kPi / 3;

/// The connected components, each with the same points.
std::vector<TriangleMesh> shells(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.points.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.unite(a, b);
    sets.unite(b, c);
  }
  std::map<std::uint32_t, TriangleMesh> by_root;
  for (const auto& triangle : mesh.triangles) {
    TriangleMesh& shell = by_root[sets.find(triangle[0])];
    shell.points = mesh.points;
    shell.triangles.push_back(triangle);
  }
  std::vector<TriangleMesh> shells;
  for (auto& [root, shell] : by_root) shells.push_back(std::move(shell));
  return shells;
}

/// A surface without a fault through all points, whose shells have these signed volumes, ascending.
Topology check_shells(const std::vector<Point3>& points, std::vector<double> volumes,
                      double tolerance) {
  const Reconstruction result = reconstruct(points);
  const auto wrong = broken_invariant(result.mesh);
  CHECK_MESSAGE(!wrong, *wrong);
  CHECK(result.hidden.empty());
  CHECK(result.mesh.points == points);
  CHECK(std::ranges::count(testing::points_in_use(result.mesh), false) == 0);
  std::vector<double> found;
  for (const TriangleMesh& shell : shells(result.mesh)) {
    found.push_back(testing::signed_volume(shell));
  }
  std::ranges::sort(found);
  std::ranges::sort(volumes);
  REQUIRE(found.size() == volumes.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(found[i] == doctest::Approx(volumes[i]).epsilon(tolerance));
  }
  return topology(result.mesh);
}

std::vector<Point3> ball(double radius, double spacing, std::uint64_t seed) {
  return point_sets::scaled(point_sets::sphere(spacing / radius, seed), radius);
}

/// The other way round than the torus of point_sets: its axis is y, and it is moved along x.
std::vector<Point3> upright_torus(double spacing, std::uint64_t seed, double along_x) {
  std::vector<Point3> points = point_sets::torus(spacing, seed);
  for (Point3& p : points) p = {p.x + along_x, -p.z, p.y};
  return points;
}

TEST_CASE("two balls apart") {
  for (const double distance : {2.6, 3.0, 10.0, 1000.0}) {
    for (const double spacing : {0.3, 0.2, 0.1}) {
      INFO("distance ", distance, ", spacing ", spacing, ", seeds 1, 2");
      const auto other = point_sets::translated(ball(1, spacing, 2), {distance, 0.1, 0.2});
      const Topology t = check_shells(point_sets::joined(ball(1, spacing, 1), other),
                                      {kBall, kBall}, spacing * spacing);
      CHECK(t.genus == 0);
    }
  }
}

TEST_CASE("a cavity is kept, and looks inward") {
  for (const double radius : {0.3, 0.5, 0.6}) {
    for (const std::uint64_t seed : testing::seeds(3)) {
      INFO("radius ", radius, ", spacing 0.1, seeds ", seed, " and 4");
      const auto points = point_sets::joined(ball(1, 0.1, seed), ball(radius, 0.1, 4));
      const Topology t = check_shells(points, {kBall, -kBall * std::pow(radius, 3)}, 0.15);
      CHECK(t.genus == 0);
    }
  }
}

TEST_CASE("a body in a cavity, and a cavity in that") {
  for (const std::uint64_t seed : testing::seeds(3)) {
    INFO("spacing 0.07, seed ", seed);
    auto points = point_sets::joined(ball(1, 0.07, seed), ball(0.7, 0.07, seed + 1));
    points = point_sets::joined(points, ball(0.4, 0.07, seed + 2));
    const double second = -kBall * 0.343, third = kBall * 0.064;
    check_shells(points, {kBall, second, third}, 0.1);
    points = point_sets::joined(points, ball(0.15, 0.04, seed + 3));
    check_shells(points, {kBall, second, third, -kBall * 0.003375}, 0.1);
  }
}

TEST_CASE("two cavities, and a ring-shaped one") {
  for (const std::uint64_t seed : testing::seeds(3)) {
    INFO("spacing 0.1, seed ", seed);
    const auto small = ball(0.3, 0.07, seed);
    auto points =
        point_sets::joined(ball(1, 0.1, seed), point_sets::translated(small, {0.5, 0, 0}));
    points = point_sets::joined(points, point_sets::translated(small, {-0.4, 0.1, 0}));
    check_shells(points, {kBall, -kBall * 0.027, -kBall * 0.027}, 0.15);
    const auto ring = point_sets::scaled(point_sets::torus(0.15, seed), 0.5);
    const Topology t = check_shells(point_sets::joined(ball(1, 0.1, seed), ring),
                                    {kBall, -2 * kPi * kPi * 0.16 / 8}, 0.1);
    CHECK(t.genus == 1);
  }
}

TEST_CASE("linked rings: two shells, genus 2 in sum") {
  const double ring = 2 * kPi * kPi * 0.16;
  for (const double spacing : {0.1, 0.07}) {
    for (const std::uint64_t seed : testing::seeds(3)) {
      INFO("spacing ", spacing, ", seeds ", seed, " and 5");
      const auto points =
          point_sets::joined(point_sets::torus(spacing, seed), upright_torus(spacing, 5, 1));
      const Topology t = check_shells(points, {ring, ring}, 4 * spacing * spacing);
      CHECK(t.genus == 2);
    }
  }
}

}  // namespace
}  // namespace tetsculpt
