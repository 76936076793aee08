// Four facets at a time give what one after the other gives: spokes bit for bit; hyperplanes and
// heights, which are rounded less often, within their errors. (tests/hull_facets_height_test holds
// them against exact signs, tests/hull_region_test what is seen.)
#include "kernel/hull_lanes.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "kernel/distinct_points.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using point_sets::Random;

/// Points of space, of a plane or of a small lattice, at several scales and places, none of them
/// equal to the first.
std::vector<Point3> random_sites(Random& random, std::size_t count) {
  const std::size_t kind = random.below(3);
  const double scale = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
  const double away = random.below(2) == 0 ? 0 : 1000;
  std::vector<Point3> sites(count);
  for (Point3& p : sites) {
    const auto coordinate = [&] {
      return kind == 2 ? static_cast<double>(random.below(4)) : random.uniform(-1, 1);
    };
    do {
      p = {(coordinate() + away) * scale, coordinate() * scale,
           kind == 1 ? 0 : coordinate() * scale};
    } while (&p != &sites[0] && p == sites[0]);
  }
  return sites;
}

/// Facets with one apex and random other corners, some of them infinite, some flat or turned inside
/// out, with no hyperplane yet; the last one's neighbours are four of the others.
struct Scene {
  std::vector<Point3> sites;
  hull::Facets facets;
  std::vector<hull::ConeFacet> cone;  ///< and the first of them again, up to a multiple of four
  std::size_t size;
  std::vector<hull::Spoke> spokes;

  Scene(Random& random, std::size_t facet_count)
      : sites(random_sites(random, 3 * facet_count + 2)),
        facets(sites, std::ldexp(1.0, *unit_exponent(sites, 10'000))),
        size(facet_count) {
    facets.append(facet_count);
    for (std::uint32_t f = 0; f < facet_count; ++f) {
      auto& c = facets.corners(f);
      c = {0, 3 * f + 1, 3 * f + 2, random.below(4) == 0 ? hull::kAtInfinity : 3 * f + 3};
      for (std::uint32_t i = 1; i < 4; ++i) {
        spokes.push_back(c[i] == hull::kAtInfinity
                             ? facets.spoke_to_infinity()
                             : hull::lifted_difference(sites[c[i]], sites[0]));
      }
      cone.push_back({f, {3 * f, 3 * f + 1, 3 * f + 2}});
      for (hull::Ridge& r : facets.neighbors(f)) {
        r = hull::ridge(static_cast<hull::FacetIndex>(random.below(facet_count)), 0);
      }
    }
    while (cone.size() % 4 != 0) cone.push_back(cone[cone.size() - size]);
  }

  std::span<const hull::ConeFacet> facets_to_set() const { return std::span(cone).first(size); }
  hull::LiftedDifference query() const { return facets.lifted(sites.back()); }

  std::vector<hull::Facets::Height> heights() const {
    std::vector<hull::Facets::Height> heights;
    for (const hull::ConeFacet& c : facets_to_set()) {
      heights.push_back(facets.height(c.facet, query()));
    }
    return heights;
  }
};

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
    hull::set_hyperplanes(scene.facets, 0, scene.facets_to_set(), scene.spokes);
    const auto expected = scene.heights();
    constexpr std::array<double, 4> kNone{1, 2, 3, 4};
    for (const hull::ConeFacet& c : scene.cone) scene.facets.set_hyperplane(c.facet, &kNone);
    hull::set_hyperplanes_by_four(scene.facets, 0, scene.facets_to_set(), scene.spokes);
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

TEST_CASE("heights above neighbours") {
  if (!hull::has_four_lanes()) {
    MESSAGE("skipped: this processor takes one facet at a time");
    return;
  }
  Random random(13);
  std::size_t visible = 0, open = 0, hidden = 0, wrong = 0;
  for (int round = 0; round < 20'000; ++round) {
    Scene scene(random, 1 + random.below(9));
    hull::set_hyperplanes(scene.facets, 0, scene.facets_to_set(), scene.spokes);
    const hull::FacetIndex f = scene.cone[0].facet;
    const auto one = hull::neighbor_heights(scene.facets, f, scene.query());
    const auto four = hull::neighbor_heights_by_four(scene.facets, f, scene.query());
    for (std::size_t i = 0; i < 4; ++i) {
      const double error = scene.facets[hull::facet_of(scene.facets.neighbors(f)[i])].error();
      wrong += !agree({one.value[i], error}, {four.value[i], error});
      wrong += (four.visible >> i & 1) != (four.value[i] > error);
      wrong += (one.visible >> i & 1) != (one.value[i] > error);
      visible += one.value[i] > error;
      hidden += one.value[i] < -error;
      open += std::fabs(one.value[i]) <= error;
    }
  }
  CHECK(wrong == 0);
  CHECK(visible > 5'000);
  CHECK(open > 5'000);
  CHECK(hidden > 5'000);
}

TEST_CASE("spokes") {
  if (!hull::has_four_lanes()) {
    MESSAGE("skipped: this processor takes one facet at a time");
    return;
  }
  Random random(12);
  for (int round = 0; round < 1'000; ++round) {
    const std::vector<Point3> sites = random_sites(random, 1 + random.below(20));
    std::vector<hull::Site> corners(4 * (1 + random.below(3)));
    for (hull::Site& s : corners) s = static_cast<hull::Site>(random.below(sites.size()));
    const auto apex = static_cast<hull::Site>(random.below(sites.size()));
    std::vector<hull::Spoke> one(corners.size());
    std::vector<hull::Spoke> four(corners.size());
    hull::set_spokes(sites, apex, corners, one.data());
    hull::set_spokes_by_four(sites, apex, corners, four.data());
    REQUIRE(std::memcmp(one.data(), four.data(), one.size() * sizeof(hull::Spoke)) == 0);
  }
}

}  // namespace
}  // namespace tetsculpt
