// Four facets at a time are given what one after the other is: links, and hyperplanes, which are
// rounded less often, within their errors. (tests/hull_facets_height_test holds them against exact
// signs.)
#include "kernel/hull_cone_lanes.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/four_lanes.h"
#include "tests/support/hull_cones.h"

namespace tetsculpt {
namespace {

using hull_cones::Random;
using hull_cones::Scene;

bool agree(const hull::Facets::Height& a, const hull::Facets::Height& b) {
  return std::fabs(a.value - b.value) <= a.error + b.error;
}

TEST_CASE("hyperplanes") {
  if (!hull::has_four_lanes()) {
    MESSAGE("skipped: this processor takes one facet at a time");
    return;
  }
  Random random(11);
  std::size_t wrong = 0, useful = 0, useless = 0;
  for (int round = 0; round < 20'000; ++round) {
    Scene scene(random, 1 + random.below(9));
    hull::finish_cone(scene.facets, 0, scene.facets_to_set(), scene.spokes.data(), {});
    const auto expected = scene.heights();
    constexpr std::array<double, 4> kNone{1, 2, 3, 4};
    for (const hull::ConeFacet& c : scene.cone) scene.facets.set_hyperplane(c.facet, &kNone);
    hull::finish_cone_by_four(scene.facets, 0, scene.facets_to_set(), scene.spokes.data(), {});
    const auto found = scene.heights();
    for (std::size_t k = 0; k < found.size(); ++k) {
      const bool bounded = expected[k].error < 0x1p500;
      (bounded ? useful : useless) += 1;
      // The next power of two may be another one.
      wrong += found[k].error > 2 * expected[k].error || expected[k].error > 2 * found[k].error;
      wrong += bounded && !agree(found[k], expected[k]);
    }
  }
  CHECK(wrong == 0);
  CHECK(useful > 30'000);
  CHECK(useless > 5'000);
}

TEST_CASE("links") {
  Random random(13);
  Scene scene(random, 7);
  const hull::SpokePlace last = scene.cone[6].spokes[2];
  std::vector<hull::Ridge> table(hull::HalfRidges::size(last));
  const hull::HalfRidges half_ridges(table.data());
  for (hull::Ridge r = 0; r < table.size(); ++r) table[r] = r;
  const auto check = [&](auto&& finish) {
    for (const hull::ConeFacet& c : scene.cone) scene.facets.neighbors(c.facet) = {7, 7, 7, 7};
    finish(scene.facets, 0, scene.facets_to_set(), scene.spokes.data(), half_ridges);
    for (const hull::ConeFacet& c : scene.facets_to_set()) {
      const auto& [a, b, d] = c.spokes;
      const auto from_to = [&](auto from, auto to) { return half_ridges(from, to); };
      const std::array expected{7u, from_to(b, d), from_to(d, a), from_to(a, b)};
      CHECK(scene.facets.neighbors(c.facet) == expected);
    }
  };
  check(hull::finish_cone);
  if (hull::has_four_lanes()) check(hull::finish_cone_by_four);
}

}  // namespace
}  // namespace tetsculpt
