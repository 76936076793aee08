// Where vertices stay hidden the constraints are lifted: the EGH alone as long as that helps, what
// has one boundary face before what has two, longest edge first.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "sculpt/boundary.h"
#include "sculpt/exposure.h"
#include "sculpt/priority.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_rules.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::Rules;

/// What a run of the method did against the constraints for the sake of a hidden vertex.
struct Lifted {
  std::size_t removals = 0;
  std::size_t with_two_faces = 0;
  std::size_t against_tree = 0;
};

/// Follows the method and checks each removal against the constraints. Such a removal is the first
/// of all that its step allows.
Lifted check_lifting(const testing::Stages& s) {
  Lifted lifted;
  const ManifoldSolid ranks = s.solid();
  const Priority priority(Criterion::kConstrained, s.points(), ranks);
  Boundary boundary(s.complex);
  Rules rules(s);
  const auto place = [&](TetId t) {
    const Exposure e = exposure(boundary, t);
    return std::tuple(e.faces, priority.key(t, e));
  };
  const auto helps_without_tree = [&](TetId t) {
    return rules.removable(t) && !rules.common_edge_in_tree(t);
  };
  bool tree_lifted = false;
  const Sculpture sculpture = s.sculpt();
  for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
    const TetId t = step.tets[0];
    if (step.hole || rules.replay().hidden_count() == 0) tree_lifted = false;
    if (!step.hole && !rules.allowed(t) && rules.replay().hidden_count() > 0) {
      tree_lifted = tree_lifted || rules.none(helps_without_tree);
      REQUIRE((tree_lifted || helps_without_tree(t)));
      REQUIRE(rules.none([&](TetId other) {
        const bool may_go = tree_lifted ? rules.removable(other) : helps_without_tree(other);
        return may_go && place(other) < place(t);
      }));
      ++lifted.removals;
      lifted.with_two_faces += rules.replay().boundary_facets(t).size() == 2;
      lifted.against_tree += rules.common_edge_in_tree(t);
    }
    for (const TetId each : step.tets) {
      boundary.remove(each);
      rules.remove(each);
    }
  }
  return lifted;
}

TEST_CASE("random boxes, where vertices often stay hidden") {
  Lifted sum;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    INFO("box of 50, seed ", seed);
    const Lifted lifted = check_lifting(testing::stages(point_sets::uniform_cube(50, seed)));
    sum.removals += lifted.removals;
    sum.with_two_faces += lifted.with_two_faces;
  }
  CHECK(sum.removals > 20);
  CHECK(sum.with_two_faces > 0);
}

// Found by a search: one of 3000 small sets.
TEST_CASE("a box in which the EMST has to yield, too") {
  const Lifted lifted = check_lifting(testing::stages(point_sets::uniform_cube(58, 2424)));
  CHECK(lifted.against_tree > 0);
}

}  // namespace
}  // namespace tetsculpt
