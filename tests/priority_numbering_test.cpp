// Keys depend on nothing but the points, not on a tetrahedron's number; to the last bit.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <tuple>

#include "sculpt/priority.h"
#include "tests/support/sculpt_replay.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using FourCorners = std::array<VertexId, 4>;

FourCorners sorted(FourCorners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// The tetrahedron with facets opposite to these of its corners, in ascending order, on the
/// boundary.
Exposure exposed(const FourCorners& tet, std::size_t first, std::size_t second) {
  const FourCorners ascending = sorted(tet);
  Exposure e;
  for (const std::size_t i : {first, second}) {
    e.facets = static_cast<std::uint8_t>(e.facets | 1u << corner_of(tet, ascending[i]));
  }
  e.faces = first == second ? 1 : 2;
  return e;
}

using Keys = std::map<std::tuple<FourCorners, std::size_t, std::size_t>, std::uint64_t>;

/// The bits of every key, for one face or two.
Keys keys(const testing::Stages& s, Criterion criterion) {
  const ManifoldSolid solid = s.solid();
  const Priority priority(criterion, s.points(), solid);
  Keys result;
  for (const TetId t : s.tets()) {
    const FourCorners& tet = s.complex.vertices(t);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i; j < 4; ++j) {
        const double key = priority.key(t, exposed(tet, i, j));
        result[{sorted(tet), i, j}] = std::bit_cast<std::uint64_t>(key);
      }
    }
  }
  return result;
}

TEST_CASE("keys of a renumbered complex are the same") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const testing::Stages other =
          testing::stages(s.distinct, testing::renumbered(s.complex, seed));
      for (const Criterion criterion : testing::kAllCriteria) {
        INFO(set, ", criterion ", static_cast<int>(criterion), ", numbering by seed ", seed);
        CHECK(keys(s, criterion) == keys(other, criterion));
      }
    }
  }
}

TEST_CASE("corners_less is the lexicographic order of corners") {
  const testing::Stages s = testing::stages(testing::small_sets().front().points);
  for (const TetId a : s.tets()) {
    for (const TetId b : s.tets()) {
      CHECK(corners_less(s.complex.vertices(a), s.complex.vertices(b)) ==
            (sorted(s.complex.vertices(a)) < sorted(s.complex.vertices(b))));
    }
  }
}

}  // namespace
}  // namespace tetsculpt
