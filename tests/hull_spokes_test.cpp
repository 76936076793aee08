// Each corner of facets that lose their marks has a spoke, the same bit for bit one at a time and
// four at a time.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "kernel/four_lanes.h"
#include "kernel/hull_cone_lanes.h"
#include "tests/support/hull_cones.h"

namespace tetsculpt {
namespace {

using hull_cones::Random;
using hull_cones::Scene;

/// What set_spokes leaves behind.
struct Spokes {
  std::vector<hull::SpokePlace> spoke_of;
  std::vector<hull::Spoke> spokes;

  template <class Set>
  Spokes(Scene& scene, std::span<const hull::Ridge> visible,
         const std::vector<hull::SpokePlace>& places, Set&& set)
      : spoke_of(scene.sites.size() + 1, hull::kNone), spokes(places.size()) {
    for (const hull::Ridge r : visible) {
      scene.facets.mark(hull::facet_of(r)) = hull::Mark::kVisible;
    }
    set(scene.facets, scene.sites, 0, visible, places.data(), spoke_of.data(), spokes.data());
  }

  /// How many facets kept a mark, and corners have no spoke or a wrong one.
  std::size_t wrong(Scene& scene, std::span<const hull::Ridge> visible) const {
    std::size_t wrong = 0;
    const auto check = [&](hull::Site s) {
      const hull::SpokePlace place = spoke_of[s == hull::kAtInfinity ? 0 : s + 1];
      const hull::Spoke expected = s == hull::kAtInfinity
                                       ? scene.facets.spoke_to_infinity()
                                       : hull::lifted_difference(scene.sites[s], scene.sites[0]);
      wrong +=
          place == hull::kNone || std::memcmp(&spokes[place / 4], &expected, sizeof expected) != 0;
    };
    for (const hull::Site s : scene.facets.corners(hull::facet_of(visible[0]))) check(s);
    for (const hull::Ridge r : visible) {
      wrong += scene.facets.mark(hull::facet_of(r)) != hull::Mark::kUnmet;
      check(scene.facets.corners(hull::facet_of(r))[hull::corner_of(r)]);
    }
    return wrong;
  }
};

TEST_CASE("spokes") {
  if (!hull::has_four_lanes()) MESSAGE("four at a time skipped: this processor takes one");
  Random random(12);
  std::size_t wrong = 0;
  for (int round = 0; round < 1'000; ++round) {
    const std::size_t size = 1 + random.below(20);
    Scene scene(random, size);
    std::vector<hull::Ridge> visible{hull::ridge(0, 0)};
    for (std::uint32_t f = 1; f < size; ++f) {
      visible.push_back(hull::ridge(f, static_cast<std::uint32_t>(random.below(4))));
    }
    visible.insert(visible.end(), 3, visible[0]);
    std::vector<hull::SpokePlace> places((size + 6) / 4 * 4);
    for (std::size_t k = 0; k < places.size(); ++k) {
      places[k] = static_cast<hull::SpokePlace>(4 * (places.size() - 1 - k));
    }
    const auto met = std::span(visible).first(size);
    wrong += Spokes(scene, met, places, hull::set_spokes).wrong(scene, met);
    if (!hull::has_four_lanes()) continue;
    wrong += Spokes(scene, met, places, hull::set_spokes_by_four).wrong(scene, met);
  }
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace tetsculpt
