// After repair every star is good, whatever the labels were; what was good stays as it is.
#include "sculpt/star_repair.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "kernel/vertex_stars.h"
#include "sculpt/evidence.h"
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

Flags random_labels(const testing::Stages& s, double share, std::uint64_t seed) {
  point_sets::Random random(seed);
  Flags inside(s.complex.tet_count(), 0);
  for (const TetId t : s.tets()) inside[+t] = random.uniform() < share;
  return inside;
}

/// Any energy at all: of either sign, and in part without a difference.
Evidence random_evidence(const testing::Stages& s, std::uint64_t seed) {
  point_sets::Random random(seed);
  Evidence evidence;
  const auto weight = [&](double low) {
    return random.below(3) == 0 ? 1.0 : random.uniform(low, 2);
  };
  for (std::size_t t = 0; t < s.complex.finite_tet_count(); ++t) {
    evidence.inside_bias.push_back(weight(-2));
  }
  for (std::size_t t = 0; t < s.complex.triangle_count(); ++t) {
    evidence.facet_cost.push_back(weight(0));
  }
  evidence.believed.resize(s.complex.vertex_count());
  return evidence;
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

TEST_CASE("random labels of any density") {
  int repaired = 0;
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const VertexStars stars(s.complex);
    std::uint64_t seed = 0;
    for (const double share : {0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98}) {
      INFO(set, ", labels and energy of seed ", ++seed);
      const Flags labels = random_labels(s, share, seed);
      Flags inside = labels;
      repair_stars(s.complex, stars, random_evidence(s, seed), inside);
      REQUIRE(inside.size() == labels.size());
      REQUIRE(bad_stars(s, stars, inside) == 0);
      REQUIRE(infinite_outside(s, inside));
      if (bad_stars(s, stars, labels) == 0) REQUIRE(inside == labels);
      repaired += inside != labels;
      const Flags once = inside;
      repair_stars(s.complex, stars, random_evidence(s, seed + 100), inside);
      REQUIRE(inside == once);
    }
  }
  CHECK(repaired > 100);
}

TEST_CASE("none and all are good as they are") {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const double share : {0.0, 1.0}) {
      INFO(set, ", share inside ", share, ", energy of seed 1");
      const Flags labels = random_labels(s, share, 1);
      Flags inside = labels;
      repair_stars(s.complex, VertexStars(s.complex), random_evidence(s, 1), inside);
      CHECK(inside == labels);
    }
  }
}

/// A finite tetrahedron that has the first corner and no other in common with t.
std::optional<TetId> touching(const testing::Stages& s, const VertexStars& stars, TetId t) {
  const auto& corners = s.complex.vertices(t);
  for (const TetId u : stars(corners[0])) {
    const auto in_t = [&](VertexId v) { return std::ranges::count(corners, v) > 0; };
    if (s.complex.finite(u) && std::ranges::count_if(s.complex.vertices(u), in_t) == 1) return u;
  }
  return std::nullopt;
}

TEST_CASE("of two tetrahedra that touch in a vertex the unlikely one goes") {
  const testing::Stages s = testing::stages(point_sets::uniform_cube(200, 1));
  const VertexStars stars(s.complex);
  int pairs = 0;
  for (const TetId t : s.tets()) {
    const auto other = touching(s, stars, t);
    if (!other) continue;
    INFO("box of 200, seed 1, tetrahedra ", +t, " and ", +*other);
    Evidence evidence = random_evidence(s, 1);
    std::ranges::fill(evidence.facet_cost, 1.0);
    std::ranges::fill(evidence.inside_bias, -10.0);
    evidence.inside_bias[+*other] = 10.0;
    Flags expected(s.complex.tet_count(), 0);
    expected[+*other] = 1;
    Flags inside = expected;
    inside[+t] = 1;
    repair_stars(s.complex, stars, evidence, inside);
    REQUIRE(inside == expected);
    ++pairs;
  }
  CHECK(pairs > 100);
}

}  // namespace
}  // namespace tetsculpt
