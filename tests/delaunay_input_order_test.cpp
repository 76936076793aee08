// The same points in any order, and any number of times, give the same tetrahedra by coordinates.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using Corners = std::array<std::array<double, 3>, 4>;

/// Input coordinates of the tetrahedra, found through the maps of distinct_points.
std::vector<Corners> tets_by_coordinates(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  std::vector<Corners> tets;
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    Corners corners;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point3& p = input[distinct.first_input[+complex.vertices(TetId{t})[i]]];
      corners[i] = {p.x, p.y, p.z};
    }
    std::sort(corners.begin(), corners.end());
    tets.push_back(corners);
  }
  std::sort(tets.begin(), tets.end());
  return tets;
}

void check_order(const std::vector<Point3>& points, std::uint64_t permutations) {
  const std::vector<Corners> expected = tets_by_coordinates(points);
  CHECK_FALSE(expected.empty());
  for (std::uint64_t seed = 0; seed < permutations; ++seed) {
    CAPTURE(seed);
    CHECK(tets_by_coordinates(point_sets::shuffled(points, seed)) == expected);
  }
  auto twice = point_sets::shuffled(point_sets::joined(points, points), 99);
  CHECK(tets_by_coordinates(twice) == expected);
}

TEST_CASE("small solids") {
  for (const auto& set : oracle::small_solids()) {
    CAPTURE(set.name);
    check_order(set.points, 5);
  }
}

TEST_CASE("middling solids") {
  for (const auto& set : oracle::middling_solids()) {
    CAPTURE(set.name);
    check_order(set.points, 2);
  }
}

TEST_CASE("5000 points on a bumpy sphere") { check_order(point_sets::bumpy_sphere(5000, 1), 2); }

TEST_CASE("moving a lattice by whole steps and doubling it changes nothing") {
  const auto points = point_sets::random_lattice(200, 6, 2);
  const auto tets = oracle::finite_tets(delaunay(distinct_points(points)));
  const auto moved = point_sets::translated(points, {1e6, -12345, 7});
  const auto doubled = point_sets::scaled(points, 0x1p300);
  CHECK(oracle::finite_tets(delaunay(distinct_points(moved))) == tets);
  CHECK(oracle::finite_tets(delaunay(distinct_points(doubled))) == tets);
}

}  // namespace
}  // namespace tetsculpt
