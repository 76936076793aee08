// The boundary's counts and the classification of tetrahedra, while removable ones go at random, or
// any are flipped.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "kernel/predicates.h"
#include "sculpt/boundary.h"
#include "sculpt/exposure.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"
#include "tests/support/sculpt_rules.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::Rules;

testing::Corners sorted(std::array<VertexId, 3> corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Compares the classification of every solid tetrahedron with the rules stated on corners.
void check_exposures(const testing::Stages& s, const Boundary& boundary, const Rules& rules) {
  for (const TetId t : s.tets()) {
    if (!boundary.solid(t)) continue;
    const Exposure e = exposure(boundary, t);
    const auto& v = s.complex.vertices(t);
    std::vector<std::size_t> on;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& c = kFacetCorners[i];
      const bool face = rules.replay().on_boundary(sorted({v[c[0]], v[c[1]], v[c[2]]}));
      REQUIRE(e.on_boundary(i) == face);
      if (face) on.push_back(i);
    }
    REQUIRE(e.faces == static_cast<int>(on.size()));
    REQUIRE(e.removable == rules.removable(t));
    REQUIRE(e.opposite_edge == (on.size() == 2 ? kEdgeOfCorners[on[0]][on[1]] : -1));
  }
}

/// Compares the boundary's triangles with the replay's, and their orientation with the solid's.
void check_triangles(const testing::Stages& s, const Boundary& boundary, const Rules& rules) {
  std::set<testing::Corners> found;
  for (const auto& triangle : boundary_triangles(s.complex, boundary.solid())) {
    REQUIRE(found.insert(sorted(triangle)).second);
  }
  REQUIRE(found == rules.replay().triangles());
  const std::vector<TetId> tets = s.tets();
  const auto at = [&](VertexId v) { return s.distinct.points[+v]; };
  for (const auto& triangle : boundary_triangles(s.complex, boundary.solid())) {
    const auto& [a, b, c] = triangle;
    const auto behind = std::ranges::find_if(tets, [&](TetId t) {
      const auto facets = testing::facets_of(s.complex.vertices(t));
      return boundary.solid(t) && std::ranges::count(facets, sorted(triangle)) == 1;
    });
    for (const VertexId d : s.complex.vertices(*behind)) {
      if (d == a || d == b || d == c) continue;
      REQUIRE(orient3d(at(a), at(b), at(c), at(d)) == Sign::kPositive);
    }
  }
}

TEST_CASE("random removals, checked after each") {
  for (const testing::NamedSet& set : testing::some_of(testing::small_sets())) {
    INFO(set, ", removals by seed 5");
    const testing::Stages s = testing::stages(set.points);
    point_sets::Random random(5);
    Boundary boundary(s.complex);
    Rules rules(s);
    for (;;) {
      const auto broken = broken_invariant(boundary);
      REQUIRE_MESSAGE(!broken, *broken);
      REQUIRE(boundary.hidden_count() == rules.replay().hidden_count());
      REQUIRE(boundary.hidden_vertices().size() == boundary.hidden_count());
      for (const VertexId v : boundary.hidden_vertices()) {
        REQUIRE_FALSE(rules.replay().on_boundary(v));
      }
      check_exposures(s, boundary, rules);
      std::vector<TetId> removable = s.tets();
      std::erase_if(removable, [&](TetId t) {
        return !boundary.solid(t) || !exposure(boundary, t).removable;
      });
      if (removable.empty()) break;
      const TetId chosen = removable[random.below(removable.size())];
      boundary.remove(chosen);
      rules.remove(chosen);
      REQUIRE_FALSE(boundary.solid(chosen));
    }
    check_triangles(s, boundary, rules);
  }
}

TEST_CASE("the boundary starts as the convex hull") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const Boundary boundary(s.complex);
    const Rules rules(s);
    CHECK(boundary_triangles(s.complex, boundary.solid()).size() ==
          s.complex.tet_count() - s.complex.finite_tet_count());
    check_triangles(s, boundary, rules);
  }
}

/// Counts over the solid's facets, each of which is on the boundary if no other solid tetrahedron
/// has it.
void check_counts(const testing::Stages& s, const Boundary& boundary) {
  std::map<testing::Corners, int> facets;
  for (const TetId t : s.tets()) {
    if (!boundary.solid(t)) continue;
    for (const testing::Corners& c : testing::facets_of(s.complex.vertices(t))) ++facets[c];
  }
  std::erase_if(facets, [](const auto& entry) { return entry.second != 1; });
  std::vector<std::size_t> triangles_at(s.complex.vertex_count(), 0);
  std::set<testing::EndPoints> edges;
  for (const auto& entry : facets) {
    for (const VertexId v : entry.first) ++triangles_at[+v];
    for (const testing::EndPoints& e : testing::edges_of(entry.first)) edges.insert(e);
  }
  std::size_t hidden = 0;
  for (std::uint32_t v = 0; v < triangles_at.size(); ++v) {
    hidden += triangles_at[v] == 0;
    REQUIRE(boundary.triangles_at(VertexId{v}) == triangles_at[v]);
  }
  REQUIRE(boundary.hidden_count() == hidden);
  const std::size_t simplices = triangles_at.size() - hidden + facets.size();
  REQUIRE(boundary.euler_characteristic() ==
          static_cast<std::int64_t>(simplices) - static_cast<std::int64_t>(edges.size()));
}

TEST_CASE("any flips, allowed or not, keep the counts") {
  std::set<std::int64_t> characteristics;
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const std::vector<TetId> tets = s.tets();
    point_sets::Random random(6);
    Boundary boundary(s.complex);
    for (int step = 0; step < 150; ++step) {
      INFO(set, ", flips of seed 6, step ", step);
      const TetId t = tets[random.below(tets.size())];
      const bool before = boundary.solid(t);
      boundary.flip(t);
      REQUIRE(boundary.solid(t) != before);
      check_counts(s, boundary);
      const auto broken = broken_invariant(boundary);
      REQUIRE_MESSAGE(!broken, *broken);
      characteristics.insert(boundary.euler_characteristic());
    }
    const Boundary anew(s.complex, boundary.solid());
    REQUIRE(anew.euler_characteristic() == boundary.euler_characteristic());
    check_counts(s, anew);
  }
  CHECK(characteristics.size() > 20);
}

TEST_CASE("all tetrahedra removed in any order: nothing is left on the boundary") {
  const testing::Stages s = testing::stages(point_sets::uniform_cube(40, 9));
  point_sets::Random random(6);
  std::vector<TetId> order = s.tets();
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  Boundary boundary(s.complex);
  CHECK(boundary.euler_characteristic() == 2);
  for (const TetId t : order) boundary.remove(t);
  CHECK(boundary.hidden_count() == s.complex.vertex_count());
  CHECK(boundary.euler_characteristic() == 0);
  check_counts(s, boundary);
}

}  // namespace
}  // namespace tetsculpt
