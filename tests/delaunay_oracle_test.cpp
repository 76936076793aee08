// The complex consists of exactly the quadruples whose perturbed sphere holds no other point: small
// sets, and subsets of lattices, against brute force.
#include <doctest/doctest.h>

#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

bool equals_oracle(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  return oracle::finite_tets(delaunay(distinct)) == oracle::delaunay(distinct.points);
}

TEST_CASE("small solids") {
  for (const auto& set : oracle::small_solids()) {
    if (distinct_points(set.points).points.size() > 50) continue;
    CAPTURE(set.name);
    CHECK(equals_oracle(set.points));
  }
}

TEST_CASE("all subsets of a cube") {
  const std::vector<Point3> corners = point_sets::grid(2);
  for (unsigned subset = 0; subset < 256; ++subset) {
    std::vector<Point3> points;
    for (unsigned i = 0; i < 8; ++i) {
      if ((subset >> i & 1) != 0) points.push_back(corners[i]);
    }
    CAPTURE(subset);
    CHECK(equals_oracle(points));
  }
}

TEST_CASE("random subsets of small lattices") {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    const std::size_t n = 4 + seed % 12;
    CHECK(equals_oracle(point_sets::random_lattice(n, 3, seed)));
    CHECK(equals_oracle(point_sets::random_lattice(n, 4, seed)));
  }
}

TEST_CASE("random subsets of a lattice sphere with its centre") {
  auto all = point_sets::lattice_sphere(9);
  all.push_back({0, 0, 0});
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    auto points = point_sets::shuffled(all, seed);
    points.resize(5 + seed % 12);
    CHECK(equals_oracle(points));
  }
}

}  // namespace
}  // namespace tetsculpt
