// Whatever a few points look like: a closed oriented 2-manifold without degenerate triangles,
// through all points.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "kernel/predicates.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"
#include "tests/support/sculpt_stages.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

constexpr std::uint64_t kSets = testing::random_cases(std::uint64_t{10000});

/// Integer points near a few centres: clusters that are clusters still where all is exact.
std::vector<Point3> integer_clusters(std::size_t n, std::uint64_t seed) {
  point_sets::Random random(seed);
  const std::size_t spread = 2 + random.below(20);
  std::vector<Point3> points(n);
  for (Point3& p : points) {
    const auto c = random.below(6) * 1000;
    const auto near = [&](std::size_t place) {
      return static_cast<double>(place + random.below(spread));
    };
    p = {near(c), near(c * c / 1000), near(c * c * c / 8000000)};
  }
  return points;
}

std::vector<Point3> on_sphere(std::size_t n, std::uint64_t seed) {
  std::vector<Point3> points = point_sets::uniform_cube(n, seed);
  for (Point3& p : points) {
    p = {p.x - 0.5, p.y - 0.5, p.z - 0.5};
    const double r = std::hypot(p.x, p.y, p.z);
    p = {p.x / r, p.y / r, p.z / r};
  }
  return points;
}

std::vector<Point3> on_lattice_sphere(std::size_t n, std::uint64_t seed) {
  point_sets::Random random(seed);
  auto points = point_sets::lattice_sphere(static_cast<long>(3 + random.below(60)));
  points = point_sets::shuffled(points, seed);
  points.resize(std::min(n, points.size()));
  if (random.below(4) == 0) points.push_back({0, 0, 0});
  return points;
}

testing::NamedSet random_set(std::uint64_t seed) {
  point_sets::Random random(seed);
  const std::size_t n = 4 + random.below(57);
  const std::string words = " of " + std::to_string(n) + ", seed " + std::to_string(seed);
  switch (seed % 6) {
    case 0:
      return {"box" + words, point_sets::uniform_cube(n, seed)};
    case 1:
      return {"lattice" + words, point_sets::random_lattice(n, 2 + random.below(4), seed)};
    case 2:
      return {"lattice sphere" + words, on_lattice_sphere(n, seed)};
    case 3:
      return {"clusters" + words, point_sets::clusters(n, seed)};
    case 4:
      return {"integer clusters" + words, integer_clusters(n, seed)};
    default:
      return {"sphere" + words, on_sphere(n, seed)};
  }
}

void check_triangles(const TriangleMesh& mesh) {
  const auto wrong = broken_invariant(mesh);
  REQUIRE_MESSAGE(!wrong, *wrong);
  const Topology t = topology(mesh);
  REQUIRE((t.closed && t.edge_manifold && t.vertex_manifold && t.oriented));
  std::set<std::array<std::uint32_t, 3>> seen;
  for (std::array<std::uint32_t, 3> triangle : mesh.triangles) {
    const auto& [a, b, c] = triangle;
    REQUIRE_FALSE(collinear(mesh.points[a], mesh.points[b], mesh.points[c]));
    std::ranges::sort(triangle);
    REQUIRE(seen.insert(triangle).second);
  }
}

/// The mesh has the first of equal input points, in their order, and none is hidden.
void check_points(const std::vector<Point3>& input, const Reconstruction& result) {
  std::vector<Point3> expected;
  const auto less = [](const Point3& a, const Point3& b) { return lexicographically_less(a, b); };
  std::set<Point3, decltype(less)> seen(less);
  for (std::size_t i = 0; i < input.size(); ++i) {
    if (!seen.insert(input[i]).second) continue;
    REQUIRE(result.vertex_of_input[i] == expected.size());
    expected.push_back(input[i]);
  }
  REQUIRE(result.counts.vertices == seen.size());
  REQUIRE(result.hidden.empty());
  REQUIRE(result.mesh.points == expected);
  REQUIRE(std::ranges::count(testing::points_in_use(result.mesh), false) == 0);
}

TEST_CASE("random small sets") {
  std::size_t solids = 0;
  for (std::uint64_t seed = 1; seed <= kSets; ++seed) {
    const testing::NamedSet set = random_set(seed);
    INFO(set);
    const Reconstruction result = reconstruct(set.points);
    if (result.span != Span::kSolid) continue;
    ++solids;
    check_triangles(result.mesh);
    check_points(set.points, result);
    // Of clusters so little may be left that rounding decides.
    if (!set.name.starts_with("clusters")) REQUIRE(testing::signed_volume(result.mesh) > 0);
  }
  CHECK(10 * solids > 9 * kSets);
}

}  // namespace
}  // namespace tetsculpt
