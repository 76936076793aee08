// Progress is told as a share that grows, and telling it changes nothing.
#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

TEST_CASE("shares from 0 to 1") {
  const DistinctPoints distinct = distinct_points(point_sets::bumpy_sphere(70000, 1));
  std::vector<double> shares;
  delaunay(distinct, {.progress = [&](double share) { shares.push_back(share); }});
  REQUIRE_FALSE(shares.empty());
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.front() >= 0);
  CHECK(shares.back() <= 1);
}

TEST_CASE("the same complex with and without") {
  const DistinctPoints distinct = distinct_points(point_sets::random_lattice(2000, 15, 2));
  const TetComplex told = delaunay(distinct, {.progress = [](double) {}});
  CHECK(oracle::finite_tets(told) == oracle::finite_tets(delaunay(distinct)));
}

}  // namespace
}  // namespace tetsculpt
