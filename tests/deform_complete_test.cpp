// A surface that has been moved towards labels can't be moved any nearer by a single flip.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sculpt/boundary.h"
#include "sculpt/circumspheres.h"
#include "sculpt/deform.h"
#include "sculpt/exposure.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

/// How many of the flips still wanted are allowed.
std::size_t flips_left(const testing::Stages& s, const Boundary& boundary, const Flags& wanted) {
  std::size_t left = 0;
  for (const TetId t : s.tets()) {
    left += boundary.solid()[+t] != wanted[+t] && exposure(boundary, t).removable;
  }
  return left;
}

/// Deforms with either order. Returns how many tetrahedra that added.
std::size_t check_complete(const testing::Stages& s, const Flags& start, const Flags& wanted) {
  const Circumspheres spheres(s.points(), s.complex);
  std::size_t added = 0;
  for (const FlipOrder order : {FlipOrder::kSmallestFirst, FlipOrder::kLargestFirst}) {
    Boundary boundary(s.complex, start);
    deform_towards(boundary, spheres, wanted, order);
    CHECK(flips_left(s, boundary, wanted) == 0);
    for (const TetId t : s.tets()) added += boundary.solid(t) && !start[+t];
  }
  return added;
}

std::vector<testing::NamedSet> all_sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  return sets;
}

TEST_CASE("from the hull") {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      INFO(set, ", labels of seed ", seed);
      check_complete(s, Boundary(s.complex).solid(), s.random_labels(0.3, seed));
    }
  }
}

// A flip that takes an edge off the boundary may set free a tetrahedron across that edge.
TEST_CASE("from a surface that has to move both ways") {
  std::size_t added = 0;
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const Circumspheres spheres(s.points(), s.complex);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      INFO(set, ", labels of seeds ", seed, " and ", seed + 10);
      Boundary start(s.complex);
      deform_towards(start, spheres, s.random_labels(0.5, seed), FlipOrder::kLargestFirst);
      const Flags wanted = s.random_labels(0.5, seed + 10);
      added += check_complete(s, start.solid(), wanted);
    }
  }
  CHECK(added > 1000);
}

}  // namespace
}  // namespace tetsculpt
