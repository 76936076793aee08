// Removals go by key: what was taken is the first of all that could have been. And the outcome does
// not depend on how the complex is numbered.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "kernel/tet_complex.h"
#include "sculpt/boundary.h"
#include "sculpt/exposure.h"
#include "sculpt/priority.h"
#include "tests/support/sculpt_rules.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::Rules;

constexpr TetId kNoTet{0xffffffffu};

/// The first by key, ties by corners, of the solid tetrahedra that `may_go`.
TetId first_of(const testing::Stages& s, const Boundary& boundary, const Priority& priority,
               const std::function<bool(TetId)>& may_go) {
  TetId best = kNoTet;
  double best_key = 0;
  for (const TetId t : s.tets()) {
    if (!boundary.solid(t) || !may_go(t)) continue;
    const double key = priority.key(t, exposure(boundary, t));
    const bool first =
        best == kNoTet || key < best_key ||
        (key == best_key && corners_less(s.complex.vertices(t), s.complex.vertices(best)));
    if (first) {
      best = t;
      best_key = key;
    }
  }
  return best;
}

TEST_CASE("each removal is the first of all removable") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const Criterion criterion : testing::kAllCriteria) {
      INFO(set, ", criterion ", static_cast<int>(criterion));
      const bool constrained = criterion == Criterion::kConstrained;
      const ManifoldSolid ranks = s.solid();
      const Priority priority(criterion, s.points(), ranks);
      Boundary boundary(s.complex);
      Rules rules(s);
      const auto may_go = [&](TetId t) {
        return constrained ? rules.allowed(t) : rules.removable(t);
      };
      const Sculpture sculpture = s.sculpt(criterion);
      for (const TetId t : sculpture.removed) {
        if (constrained && !rules.allowed(t)) break;  // the end of the first run
        REQUIRE(first_of(s, boundary, priority, may_go) == t);
        boundary.remove(t);
        rules.remove(t);
      }
    }
  }
}

std::set<std::array<VertexId, 4>> solid_corners(const testing::Stages& s,
                                                const Sculpture& sculpture) {
  std::set<std::array<VertexId, 4>> corners;
  for (const TetId t : s.tets()) {
    auto v = s.complex.vertices(t);
    std::sort(v.begin(), v.end());
    if (sculpture.solid[+t]) corners.insert(v);
  }
  return corners;
}

TEST_CASE("the numbering of the complex does not count") {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (const testing::NamedSet& set : testing::bodies()) sets.push_back(set);
  for (const testing::NamedSet& set : sets) {
    const testing::Stages s = testing::stages(set.points);
    const testing::Stages other = testing::stages(s.distinct, testing::renumbered(s.complex, 7));
    REQUIRE_FALSE(broken_invariant(other.complex, other.points()));
    for (const Criterion criterion : testing::kAllCriteria) {
      INFO(set, ", criterion ", static_cast<int>(criterion));
      CHECK(solid_corners(s, s.sculpt(criterion)) == solid_corners(other, other.sculpt(criterion)));
    }
  }
}

}  // namespace
}  // namespace tetsculpt
