// Pseudo-prisms against a search through all chains of three tetrahedra, by the definition on
// corners.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "sculpt/boundary.h"
#include "sculpt/priority.h"
#include "sculpt/pseudo_prism.h"
#include "tests/support/sculpt_prisms.h"
#include "tests/support/sculpt_rules.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::Chain;
using testing::Rules;

/// The prisms that the library finds, from all boundary facets.
std::set<Chain> found_prisms(const testing::Stages& s, const Boundary& boundary,
                             const Flags& flagged) {
  std::set<Chain> prisms;
  for (const TetId t : s.tets()) {
    if (!boundary.solid(t)) continue;
    for (int i = 0; i < 4; ++i) {
      if (!exposure(boundary, t).on_boundary(static_cast<std::size_t>(i))) continue;
      const auto from_here = pseudo_prisms(boundary, t, i, flagged);
      REQUIRE(from_here.size() <= 6);
      for (const PseudoPrism& prism : from_here) REQUIRE(prisms.insert(prism.tets).second);
    }
  }
  return prisms;
}

/// All prisms by definition, compared with the library's in both functions.
std::set<Chain> check_prisms(const testing::Stages& s, const Boundary& boundary, const Rules& rules,
                             const Flags& flagged) {
  const std::set<testing::EndPoints> edges = testing::end_points(s, flagged);
  std::set<Chain> prisms;
  for (const Chain& chain : testing::all_chains(s, rules)) {
    const bool prism = testing::is_prism(s, rules, chain, edges);
    REQUIRE(is_pseudo_prism(boundary, PseudoPrism{chain}, flagged) == prism);
    if (prism) prisms.insert(chain);
  }
  REQUIRE(found_prisms(s, boundary, flagged) == prisms);
  return prisms;
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
    Boundary boundary(s.complex);
    Rules rules(s);
    const Sculpture sculpture = s.sculpt();
    for (const TetId t : sculpture.removed) {
      boundary.remove(t);
      rules.remove(t);
    }
    prisms += check_prisms(s, boundary, rules, Flags(s.complex.edge_count(), 1)).size();
    CHECK(check_prisms(s, boundary, rules, Flags(s.complex.edge_count(), 0)).empty());
    // The method ends when no pseudo-prism would bring a tree edge out.
    CHECK(check_prisms(s, boundary, rules, s.constraints.emst_edges).empty());
  }
  CHECK(prisms > 100);
}

TEST_CASE("each hole is opened by the pseudo-prism with the longest boundary edge") {
  for (const testing::NamedSet& set : testing::bodies()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const Priority priority(Criterion::kConstrained, s.points(), s.complex);
    Boundary boundary(s.complex);
    Rules rules(s);
    const auto rank = [&](const Chain& chain) {
      return std::max(priority.longest_edge_rank(chain[0], exposure(boundary, chain[0])),
                      priority.longest_edge_rank(chain[2], exposure(boundary, chain[2])));
    };
    const Sculpture sculpture = s.sculpt();
    for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
      if (step.hole) {
        const auto prisms = check_prisms(s, boundary, rules, s.constraints.emst_edges);
        const Chain taken{step.tets[0], step.tets[1], step.tets[2]};
        REQUIRE(prisms.contains(taken));
        for (const Chain& other : prisms) REQUIRE(rank(other) <= rank(taken));
      }
      for (const TetId t : step.tets) {
        boundary.remove(t);
        rules.remove(t);
      }
    }
  }
}

}  // namespace
}  // namespace tetsculpt
