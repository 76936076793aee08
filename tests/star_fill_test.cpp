// After filling every star is good, whatever the labels were; nothing is taken off, and what was
// good stays as it is.
#include "sculpt/star_fill.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/vertex_stars.h"
#include "sculpt/star_inspector.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

std::vector<testing::NamedSet> all_sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  sets.push_back({"box of 1000, seed 1", point_sets::uniform_cube(1000, 1)});
  sets.push_back({"grid of side 7", point_sets::grid(7)});
  sets.push_back({"lattice sphere 194", point_sets::lattice_sphere(194)});
  return sets;
}

int bad_stars(const testing::Stages& s, const VertexStars& stars, const Flags& inside) {
  StarInspector inspector(s.complex, stars);
  int bad = 0;
  for (std::uint32_t v = 0; v < s.complex.vertex_count(); ++v) {
    bad += inspector.parts(VertexId{v}, inside).excess() > 0;
  }
  return bad;
}

bool infinite_outside(const testing::Stages& s, const Flags& inside) {
  return std::all_of(inside.begin() + static_cast<long>(s.complex.finite_tet_count()), inside.end(),
                     [](std::uint8_t flag) { return flag == 0; });
}

std::size_t inside_count(const Flags& inside) {
  return static_cast<std::size_t>(std::ranges::count(inside, 1));
}

/// No label of the first is missing in the second.
bool only_added(const Flags& before, const Flags& after) {
  return before.size() == after.size() && std::equal(before.begin(), before.end(), after.begin(),
                                                     [](auto a, auto b) { return a <= b; });
}

TEST_CASE("random labels of any density") {
  int filled = 0, short_of_all = 0;
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const VertexStars stars(s.complex);
    std::uint64_t seed = 0;
    for (const double share : {0.0005, 0.005, 0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98}) {
      INFO(set, ", labels of seed ", ++seed);
      const Flags labels = s.random_labels(share, seed);
      Flags inside = labels;
      fill_bad_stars(s.complex, stars, inside);
      REQUIRE(only_added(labels, inside));
      REQUIRE(bad_stars(s, stars, inside) == 0);
      REQUIRE(infinite_outside(s, inside));
      if (bad_stars(s, stars, labels) == 0) REQUIRE(inside == labels);
      filled += inside != labels;
      short_of_all += inside != labels && inside_count(inside) < s.complex.finite_tet_count();
      const Flags once = inside;
      fill_bad_stars(s.complex, stars, inside);
      REQUIRE(inside == once);
    }
  }
  CHECK(filled > 100);
  CHECK(short_of_all > 10);
}

TEST_CASE("none and all are good as they are") {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const double share : {0.0, 1.0}) {
      INFO(set, ", share inside ", share);
      const Flags labels = s.random_labels(share, 1);
      Flags inside = labels;
      fill_bad_stars(s.complex, VertexStars(s.complex), inside);
      CHECK(inside == labels);
    }
  }
}

TEST_CASE("two tetrahedra that touch in a vertex: what is added fills its star") {
  const testing::Stages s = testing::stages(point_sets::uniform_cube(200, 1));
  const VertexStars stars(s.complex);
  int pairs = 0;
  for (const TetId t : s.tets()) {
    const VertexId v = s.complex.vertices(t)[0];
    const auto in_t = [&](VertexId u) { return std::ranges::count(s.complex.vertices(t), u) > 0; };
    for (const TetId other : stars(v)) {
      if (!s.complex.finite(other)) continue;
      if (std::ranges::count_if(s.complex.vertices(other), in_t) != 1) continue;
      INFO("box of 200, seed 1, tetrahedra ", +t, " and ", +other);
      Flags inside(s.complex.tet_count(), 0);
      inside[+t] = inside[+other] = 1;
      fill_bad_stars(s.complex, stars, inside);
      const auto filled = [&](TetId u) { return !s.complex.finite(u) || inside[+u]; };
      REQUIRE(std::ranges::all_of(stars(v), filled));
      REQUIRE(bad_stars(s, stars, inside) == 0);
      ++pairs;
      break;
    }
  }
  CHECK(pairs > 100);
}

}  // namespace
}  // namespace tetsculpt
