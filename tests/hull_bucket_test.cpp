// The tetrahedra of a bucket, whatever their order before, come with corners in ascending order, an
// even number of exchanges away from the facet's, and among each other in the order of corners.
#include "kernel/hull_bucket.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel/four_lanes.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using hull::FacetIndex;
using hull::FacetLinks;
using hull::kAtInfinity;
using point_sets::Random;

constexpr std::uint32_t kLowest = 7;
constexpr std::uint32_t kBegin = 5;  ///< tetrahedra of other buckets before

/// Facets with one lowest corner, no two with the same second and third; neighbours are numbers
/// that tell where they were.
std::vector<FacetLinks> random_facets(Random& random, std::size_t count) {
  std::vector<FacetLinks> facets;
  for (std::uint32_t f = 0; f < count; ++f) {
    const std::uint32_t second = 100 + 2 * static_cast<std::uint32_t>(random.below(1000));
    std::array<std::uint32_t, 4> corners{kLowest, second, 3000 + f, 9000 + f};
    if (random.below(4) == 0) corners = {kLowest, 101 + 2 * f, 3000 + f, kAtInfinity};
    for (std::size_t i = 3; i > 0; --i) std::swap(corners[i], corners[random.below(i + 1)]);
    facets.push_back({corners, {4 * f, 4 * f + 1, 4 * f + 2, 4 * f + 3}});
  }
  return facets;
}

bool even(const std::array<std::uint32_t, 4>& numbers) {
  std::size_t exchanges = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) exchanges += numbers[j] < numbers[i];
  }
  return exchanges % 2 == 0;
}

/// A facet's corners in the order of a tetrahedron.
std::array<std::uint32_t, 4> in_tet(std::array<std::uint32_t, 4> corners) {
  const bool keeps = even(corners);
  std::ranges::sort(corners);
  if (!keeps) std::swap(corners[2], corners[3]);
  return corners;
}

template <class Write>
std::size_t wrong_tets(Random& random, std::size_t count, Write&& write) {
  const std::vector<FacetLinks> before = random_facets(random, count);
  std::vector<FacetLinks> facets = before;
  std::vector<FacetIndex> list(kBegin + count, 0);
  std::iota(list.begin() + kBegin, list.end(), 0);
  for (std::size_t k = count; k > 1; --k) {
    std::swap(list[kBegin + k - 1], list[kBegin + random.below(k)]);
  }
  LiftedHull hull;
  hull.tets.resize(list.size());
  hull.neighbors.resize(list.size());
  write(facets.data(), list, kBegin, static_cast<std::uint32_t>(list.size()), hull);
  std::size_t wrong = 0;
  for (std::size_t t = kBegin; t < list.size(); ++t) {
    const std::uint32_t f = hull.neighbors[t][0] / 4;
    std::array<std::uint32_t, 4> corners;
    for (std::size_t p = 0; p < 4; ++p) {
      const std::uint32_t corner = hull.neighbors[t][p] % 4;
      corners[p] = static_cast<std::uint32_t>(+hull.tets[t][p]);
      wrong += corners[p] != before[f].corners[corner];
      wrong += hull.neighbors[t][p] / 4 != f;
      wrong += facets[f].corners[corner] != 4 * t + p;
    }
    wrong += corners != in_tet(before[f].corners);
    if (t == kBegin) continue;
    std::array<std::uint32_t, 4> last;
    for (std::size_t p = 0; p < 4; ++p) last[p] = static_cast<std::uint32_t>(+hull.tets[t - 1][p]);
    wrong += !(last < corners);
  }
  return wrong;
}

template <class Write>
void check_buckets(Write&& write) {
  Random random(5);
  for (int round = 0; round < 300; ++round) {
    const std::size_t count = round < 200 ? 1 + random.below(20) : 55 + random.below(400);
    REQUIRE(wrong_tets(random, count, write) == 0);
  }
}

TEST_CASE("one corner at a time") { check_buckets(hull::write_bucket); }

TEST_CASE("four corners at a time") {
  if (!hull::has_four_lanes()) {
    MESSAGE("skipped: this processor takes one at a time");
    return;
  }
  check_buckets(hull::write_bucket_by_four);
}

}  // namespace
}  // namespace tetsculpt
