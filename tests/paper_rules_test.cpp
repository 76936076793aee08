// What each removal of the paper's method was allowed to do, judged by a replay of the test's own.
#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <vector>

#include "tests/support/sculpt_replay.h"
#include "tests/support/sculpt_rules.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::Replay;
using testing::Rules;

std::vector<testing::NamedSet> all_sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  std::ranges::move(testing::bodies(), std::back_inserter(sets));
  return sets;
}

TEST_CASE("the solid is what was not removed, and nothing goes twice") {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const Criterion criterion : testing::kAllCriteria) {
      INFO(set, ", criterion ", static_cast<int>(criterion));
      const Sculpture sculpture = s.sculpt(criterion);
      const std::set<TetId> removed(sculpture.removed.begin(), sculpture.removed.end());
      REQUIRE(removed.size() == sculpture.removed.size());
      for (const TetId t : s.tets()) {
        REQUIRE((sculpture.solid[+t] != 0) == !removed.contains(t));
      }
    }
  }
}

TEST_CASE("the basic rules hold for all that goes alone") {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const Criterion criterion : testing::kAllCriteria) {
      INFO(set, ", criterion ", static_cast<int>(criterion));
      const Sculpture sculpture = s.sculpt(criterion);
      Rules rules(s);
      for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
        if (!step.hole) REQUIRE(rules.removable(step.tets[0]));
        for (const TetId t : step.tets) rules.remove(t);
      }
    }
  }
}

TEST_CASE("unconstrained criteria stop at the moment when no vertex is hidden") {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const Criterion criterion :
         {Criterion::kMinimalArea, Criterion::kGamma, Criterion::kLongestEdge}) {
      INFO(set, ", criterion ", static_cast<int>(criterion));
      const Sculpture sculpture = s.sculpt(criterion);
      Rules rules(s);
      for (const TetId t : sculpture.removed) {
        REQUIRE(rules.replay().hidden_count() > 0);
        rules.remove(t);
      }
      CHECK(rules.replay().hidden_count() == sculpture.hidden.size());
      if (!sculpture.hidden.empty()) CHECK(rules.none(&Rules::removable));
    }
  }
}

TEST_CASE("the constraints yield only where a vertex is hidden or a tree edge comes out") {
  for (const testing::NamedSet& set : all_sets()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const Sculpture sculpture = s.sculpt();
    Rules rules(s);
    for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
      const TetId t = step.tets[0];
      if (!step.hole && !rules.allowed(t)) {
        REQUIRE((rules.replay().hidden_count() > 0 || rules.exposes_tree_edge(t)));
      }
      if (step.hole) REQUIRE(rules.replay().hidden_count() == sculpture.hidden.size());
      for (const TetId each : step.tets) rules.remove(each);
    }
  }
}

TEST_CASE("the first constrained run ends only when it allows nothing more") {
  for (const testing::NamedSet& set : all_sets()) {
    for (const auto stop : {PaperOptions::Stop::kHeapEmpty, PaperOptions::Stop::kAllExposed}) {
      INFO(set, ", stop ", static_cast<int>(stop));
      const testing::Stages s = testing::stages(set.points);
      const Sculpture sculpture = s.sculpt(Criterion::kConstrained, stop);
      Rules rules(s);
      for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
        if (step.hole || !rules.allowed(step.tets[0])) break;
        rules.remove(step.tets[0]);
      }
      const bool all_exposed = rules.replay().hidden_count() == 0;
      const bool may_stop = stop == PaperOptions::Stop::kAllExposed && all_exposed;
      CHECK((may_stop || rules.none(&Rules::allowed)));
    }
  }
}

TEST_CASE("a vertex stays hidden only if the basic rules let nothing more go") {
  const testing::Stages s = testing::stages(testing::set_with_hidden_point());
  const Sculpture sculpture = s.sculpt();
  REQUIRE(sculpture.hidden.size() == 1);
  Rules rules(s);
  for (const TetId t : sculpture.removed) rules.remove(t);
  CHECK_FALSE(rules.replay().on_boundary(sculpture.hidden[0]));
  CHECK(rules.none(&Rules::removable));
}

// Step 3 may leave something that step 1 would take; only a new hole leads back to step 1.
TEST_CASE("at the end no removal by the basic rules would bring a tree edge out") {
  for (const testing::NamedSet& set : all_sets()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    Rules rules(s);
    const Sculpture sculpture = s.sculpt();
    for (const TetId t : sculpture.removed) rules.remove(t);
    CHECK(rules.none([&](TetId t) { return rules.removable(t) && rules.exposes_tree_edge(t); }));
  }
}

}  // namespace
}  // namespace tetsculpt
