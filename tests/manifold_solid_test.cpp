// The solid of the paper's method against a Boundary made anew, after each of its removals.
#include "sculpt/manifold_solid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "sculpt/boundary.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_rules.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

std::vector<TetId> removable(const testing::Stages& s, const ManifoldSolid& solid) {
  std::vector<TetId> tets = s.tets();
  std::erase_if(tets, [&](TetId t) { return !solid.solid(t) || !exposure(solid, t).removable; });
  return tets;
}

/// Which tetrahedra have other faces than before?
std::set<TetId> changed(const testing::Stages& s, const ManifoldSolid& before,
                        const ManifoldSolid& after) {
  std::set<TetId> tets;
  for (const TetId t : s.tets()) {
    if (after.solid(t) && before.faces(t) != after.faces(t)) tets.insert(t);
  }
  return tets;
}

TEST_CASE("random removals that the rules allow, checked after each") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set, ", removals by seed 3");
    const testing::Stages s = testing::stages(set.points);
    point_sets::Random random(3);
    ManifoldSolid solid = s.solid();
    Boundary boundary(s.complex);
    for (;;) {
      const auto broken = broken_invariant(solid);
      REQUIRE_MESSAGE(!broken, *broken);
      for (const TetId t : s.tets()) {
        if (!solid.solid(t)) continue;
        REQUIRE(exposure(solid, t).removable == exposure(boundary, t).removable);
      }
      const std::vector<TetId> may_go = removable(s, solid);
      if (may_go.empty()) break;
      const TetId t = may_go[random.below(may_go.size())];
      const ManifoldSolid before = solid;
      std::set<TetId> told;
      solid.remove(t, [&](TetId u) { told.insert(u); });
      boundary.remove(t);
      REQUIRE(told == changed(s, before, solid));
      REQUIRE(solid.solid() == boundary.solid());
    }
  }
}

TEST_CASE("all of the method's removals, holes included") {
  std::size_t holes = 0;
  for (const testing::NamedSet& set : testing::bodies()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    ManifoldSolid solid = s.solid();
    const auto ignore = [](TetId) {};
    const Sculpture sculpture = s.sculpt();
    for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
      if (!step.hole) {
        solid.remove(step.tets[0], ignore);
        continue;
      }
      solid.remove_prism({step.tets[0], step.tets[1], step.tets[2]}, ignore);
      ++holes;
      const auto broken = broken_invariant(solid);
      REQUIRE_MESSAGE(!broken, *broken);
    }
    const auto broken = broken_invariant(solid);
    REQUIRE_MESSAGE(!broken, *broken);
  }
  CHECK(holes > 1);
}

TEST_CASE("ranks, EGH and EMST are those of the complex") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const ManifoldSolid solid = s.solid();
    const auto order = edges_by_length(s.points(), s.complex, Flags(s.complex.edge_count(), 1));
    for (const TetId t : s.tets()) {
      REQUIRE(solid.vertices(t) == s.complex.vertices(t));
      REQUIRE(solid.note(t) == 0);
      for (int k = 0; k < 6; ++k) {
        const EdgeId e = s.complex.edge(t, k);
        REQUIRE(order[solid.rank(t, k)] == e);
        REQUIRE(solid.in_emst(t, k) == (s.constraints.emst_edges[+e] != 0));
      }
      for (int i = 0; i < 4; ++i) {
        REQUIRE(solid.neighbor(t, i) == s.complex.neighbor(t, i));
        REQUIRE((solid.egh_facets(t) >> i & 1) ==
                s.constraints.egh_triangles[+s.complex.triangle(t, i)]);
      }
    }
  }
}

}  // namespace
}  // namespace tetsculpt
