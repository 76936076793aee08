// Pseudo-prisms against a search through all chains of three tetrahedra, by the definition on
// corners.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "sculpt/manifold_solid.h"
#include "sculpt/pseudo_prism.h"
#include "tests/support/sculpt_prisms.h"
#include "tests/support/sculpt_rules.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::Chain;
using testing::Rules;

/// The prisms that the library finds, from all boundary facets.
std::set<Chain> found_prisms(const testing::Stages& s, const ManifoldSolid& solid) {
  std::set<Chain> prisms;
  for (const TetId t : s.tets()) {
    if (!solid.solid(t)) continue;
    for (int i = 0; i < 4; ++i) {
      if ((solid.faces(t) >> i & 1) == 0) continue;
      const auto from_here = pseudo_prisms(solid, t, i);
      REQUIRE(from_here.size() <= 6);
      for (const PseudoPrism& prism : from_here) REQUIRE(prisms.insert(prism.tets).second);
    }
  }
  return prisms;
}

/// All prisms by definition, compared with the library's in both functions.
std::set<Chain> check_prisms(const testing::Stages& s, const ManifoldSolid& solid,
                             const Rules& rules, const Flags& emst_edges) {
  const std::set<testing::EndPoints> edges = testing::end_points(s, emst_edges);
  std::set<Chain> prisms;
  for (const Chain& chain : testing::all_chains(s, rules)) {
    const bool prism = testing::is_prism(s, rules, chain, edges);
    REQUIRE(is_pseudo_prism(solid, PseudoPrism{chain}) == prism);
    if (prism) prisms.insert(chain);
  }
  REQUIRE(found_prisms(s, solid) == prisms);
  return prisms;
}

void remove(ManifoldSolid& solid, Rules& rules, const testing::RemovalStep& step) {
  const auto ignore = [](TetId) {};
  if (step.hole) {
    solid.remove_prism({step.tets[0], step.tets[1], step.tets[2]}, ignore);
  } else {
    solid.remove(step.tets[0], ignore);
  }
  for (const TetId t : step.tets) rules.remove(t);
}

/// All prisms at the end of sculpting, if these edges were the EMST.
std::size_t prisms_at_end(const testing::Stages& s, const Sculpture& sculpture,
                          const Flags& emst_edges) {
  ManifoldSolid solid(s.points(), s.complex, {s.constraints.egh_triangles, emst_edges});
  Rules rules(s);
  for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
    remove(solid, rules, step);
  }
  return check_prisms(s, solid, rules, emst_edges).size();
}

std::vector<testing::NamedSet> sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  return sets;
}

TEST_CASE("at the end of sculpting, all edges flagged, those of the EMST, or none") {
  std::size_t prisms = 0;
  for (const testing::NamedSet& set : sets()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const Sculpture sculpture = s.sculpt();
    prisms += prisms_at_end(s, sculpture, Flags(s.complex.edge_count(), 1));
    CHECK(prisms_at_end(s, sculpture, Flags(s.complex.edge_count(), 0)) == 0);
    // The method ends when no pseudo-prism would bring a tree edge out.
    CHECK(prisms_at_end(s, sculpture, s.constraints.emst_edges) == 0);
  }
  CHECK(prisms > 100);
}

TEST_CASE("each hole is opened by the pseudo-prism with the longest boundary edge") {
  for (const testing::NamedSet& set : testing::bodies()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    ManifoldSolid solid = s.solid();
    Rules rules(s);
    const auto rank = [&](const Chain& chain) {
      return std::max(solid.longest_rank(chain[0], solid.faces(chain[0])),
                      solid.longest_rank(chain[2], solid.faces(chain[2])));
    };
    const Sculpture sculpture = s.sculpt();
    for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
      if (step.hole) {
        const auto prisms = check_prisms(s, solid, rules, s.constraints.emst_edges);
        const Chain taken{step.tets[0], step.tets[1], step.tets[2]};
        REQUIRE(prisms.contains(taken));
        for (const Chain& other : prisms) REQUIRE(rank(other) <= rank(taken));
      }
      remove(solid, rules, step);
    }
  }
}

}  // namespace
}  // namespace tetsculpt
