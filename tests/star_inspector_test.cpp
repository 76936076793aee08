// Parts of stars, counted over by joining neighbours pair by pair.
#include "sculpt/star_inspector.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "kernel/disjoint_sets.h"
#include "kernel/vertex_stars.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

/// The corners of a and b have v and two others in common.
bool share_facet_at(const TetComplex& complex, VertexId v, TetId a, TetId b) {
  int common = 0;
  bool with_v = false;
  for (const VertexId u : complex.vertices(a)) {
    if (std::ranges::count(complex.vertices(b), u) == 0) continue;
    ++common;
    with_v = with_v || u == v;
  }
  return common == 3 && with_v;
}

/// All tetrahedra at v, found by looking at every one.
std::vector<TetId> star_of(const TetComplex& complex, VertexId v) {
  std::vector<TetId> star;
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    if (std::ranges::count(complex.vertices(TetId{t}), v) > 0) star.push_back(TetId{t});
  }
  return star;
}

StarParts count_parts(const TetComplex& complex, VertexId v, const std::vector<TetId>& star,
                      const Flags& inside) {
  DisjointSets sets(star.size());
  for (std::size_t i = 0; i < star.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (inside[+star[i]] == inside[+star[j]] && share_facet_at(complex, v, star[i], star[j])) {
        sets.unite(i, j);
      }
    }
  }
  StarParts parts;
  for (std::size_t i = 0; i < star.size(); ++i) {
    if (sets.find(i) == i) ++(inside[+star[i]] ? parts.inside : parts.outside);
  }
  return parts;
}

Flags random_labels(const TetComplex& complex, double share, std::uint64_t seed) {
  point_sets::Random random(seed);
  Flags inside(complex.tet_count(), 0);
  for (std::size_t t = 0; t < complex.finite_tet_count(); ++t) {
    inside[t] = random.uniform() < share;
  }
  return inside;
}

TEST_CASE("stars hold the tetrahedra at their vertex, in order of id") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const VertexStars stars(s.complex);
    for (std::uint32_t v = 0; v < s.complex.vertex_count(); ++v) {
      REQUIRE(std::ranges::equal(stars(VertexId{v}), star_of(s.complex, VertexId{v})));
    }
  }
}

TEST_CASE("parts of random labels of any density") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const VertexStars stars(s.complex);
    StarInspector inspector(s.complex, stars);
    std::vector<Flags> labels;
    for (const double share : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
      labels.push_back(random_labels(s.complex, share, labels.size() + 1));
    }
    for (std::uint32_t v = 0; v < s.complex.vertex_count(); ++v) {
      const std::vector<TetId> star = star_of(s.complex, VertexId{v});
      for (std::size_t k = 0; k < labels.size(); ++k) {
        INFO(set, ", vertex ", v, ", labels of seed ", k + 1);
        const StarParts expected = count_parts(s.complex, VertexId{v}, star, labels[k]);
        const StarParts parts = inspector.parts(VertexId{v}, labels[k]);
        REQUIRE(parts.inside == expected.inside);
        REQUIRE(parts.outside == expected.outside);
      }
    }
  }
}

TEST_CASE("excess and one-sidedness") {
  const auto parts = [](int inside, int outside) { return StarParts{inside, outside}; };
  CHECK(parts(0, 1).excess() == 0);
  CHECK(parts(1, 0).excess() == 0);
  CHECK(parts(1, 1).excess() == 0);
  CHECK(parts(3, 1).excess() == 2);
  CHECK(parts(1, 3).excess() == 2);
  CHECK(parts(2, 4).excess() == 4);
  CHECK(parts(0, 1).one_sided());
  CHECK(parts(1, 0).one_sided());
  CHECK_FALSE(parts(2, 1).one_sided());
}

}  // namespace
}  // namespace tetsculpt
