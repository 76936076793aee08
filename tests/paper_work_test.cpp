// The operations that sculpting counts: consistent with what it removed, the same whatever the
// numbering, and within the bounds that the argument of the paper's section 3.3 rests on.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

std::vector<testing::NamedSet> all_sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  std::ranges::move(testing::bodies(), std::back_inserter(sets));
  sets.push_back({"skew lines", point_sets::skew_lines(24)});
  return sets;
}

template <class Check>
void for_all_sculptures(Check&& check) {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const Criterion criterion : testing::kAllCriteria) {
      INFO(set, ", criterion ", static_cast<int>(criterion));
      check(s, criterion, s.sculpt(criterion));
    }
  }
}

TEST_CASE("each removal is a pop that was not stale, or one of a prism's three") {
  for_all_sculptures([](const testing::Stages&, Criterion, const Sculpture& sculpture) {
    const Sculpture::Work& work = sculpture.work;
    REQUIRE(work.pops <= work.pushes);
    REQUIRE(work.stale <= work.pops);
    REQUIRE(sculpture.removed.size() == work.pops - work.stale + 3 * sculpture.holes.size());
    REQUIRE(sculpture.holes.size() <= work.prisms);
  });
}

TEST_CASE("work is linear in the tetrahedra, whatever the points and the number of holes") {
  for_all_sculptures([](const testing::Stages& s, Criterion, const Sculpture& sculpture) {
    const Sculpture::Work& work = sculpture.work;
    // The log has the tetrahedra at the hull and up to four neighbours of each one removed. Each of
    // the four steps of the paper's own criterion reads it once, and so does the search for prisms.
    const std::size_t log = s.complex.finite_tet_count() + 4 * sculpture.removed.size();
    REQUIRE(work.pushes <= 4 * log);
    REQUIRE(work.bases <= 4 * log);
    REQUIRE(work.prisms <= 6 * work.bases);
    REQUIRE(work.looks >= work.pushes + work.pops - work.stale);
    REQUIRE(work.looks <= 5 * log + work.pops + 2 * work.prisms);
  });
}

TEST_CASE("criteria without constraints look for no prisms") {
  for_all_sculptures([](const testing::Stages&, Criterion criterion, const Sculpture& sculpture) {
    if (criterion == Criterion::kConstrained) return;
    REQUIRE(sculpture.work.bases == 0);
    REQUIRE(sculpture.work.prisms == 0);
  });
}

TEST_CASE("a second run counts the same") {
  for_all_sculptures([](const testing::Stages& s, Criterion criterion, const Sculpture& sculpture) {
    REQUIRE(s.sculpt(criterion).work == sculpture.work);
  });
}

TEST_CASE("skew lines, the worst case: nearly every tetrahedron goes, none is pushed in vain") {
  const testing::Stages s = testing::stages(point_sets::skew_lines(40));
  const Sculpture sculpture = s.sculpt();
  REQUIRE(s.complex.finite_tet_count() == 39 * 39);
  CHECK(sculpture.removed.size() > 38 * 38 - 1);
  CHECK(sculpture.work.pushes < 39 * 39);
}

TEST_CASE("one tetrahedron: never pushed, its four facets tried as bases of prisms") {
  const testing::Stages s =
      testing::stages(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  for (const Criterion criterion : testing::kAllCriteria) {
    const Sculpture sculpture = s.sculpt(criterion);
    CHECK(sculpture.removed.empty());
    CHECK(sculpture.work.pushes == 0);
    CHECK(sculpture.work.pops == 0);
    CHECK(sculpture.work.bases == (criterion == Criterion::kConstrained ? 4 : 0));
  }
}

}  // namespace
}  // namespace tetsculpt
