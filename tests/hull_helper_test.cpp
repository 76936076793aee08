// A helper of an inserter, in one range after another: it begins where a facet is known, and marks
// what died before others ask.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/four_lanes.h"
#include "kernel/hull_inserter.h"
#include "tests/support/hull_regions.h"
#include "tests/support/point_sets.h"
#include "tests/support/site_blocks.h"

namespace tetsculpt::hull {
namespace {

using hull_regions::blocks_of;
using hull_regions::SiteBlocks;

constexpr std::size_t kSites = 2000;
constexpr std::size_t kWaiting = 400;

/// The last sites on the curve wait, and nothing is known about where they go in.
struct Waiting {
  LargeArray<Point3> points = distinct_points(point_sets::uniform_cube(kSites, 1)).points;
  hull_regions::Hull facets{points, kWaiting};
  std::vector<FacetIndex> known = std::vector<FacetIndex>((kSites - 1) / kGroup + 1, kNone);
  Inserter inserter{points, facets, {}, has_four_lanes(), known};
  SiteSet sites{kSites};

  Waiting() {
    for (auto s = static_cast<Site>(kSites - kWaiting); s < kSites; ++s) sites.insert(s);
  }
  void insert(Site s) {
    REQUIRE(inserter.insert(s));
    sites.erase(s);
    inserter.mark_free();
  }
  /// How many sites a helper inserts in a range.
  std::size_t inserted_in(Inserter& helper, const SiteBlocks& blocks) {
    const std::size_t before = sites.count();
    helper.move_to(blocks.range(), sites);
    const auto tally = helper.insert_all(sites, [](std::size_t) { return true; });
    CHECK(tally.inserted == before - sites.count());
    return tally.inserted;
  }
};

const SiteBlocks kAll = blocks_of(kSites, 0, kSites);

TEST_CASE("where nothing is known nothing goes in") {
  Waiting waiting;
  Inserter helper = waiting.inserter.helper();
  CHECK(waiting.inserted_in(helper, kAll) == 0);
  CHECK(waiting.sites.count() == kWaiting);
}

TEST_CASE("begins at a facet that is known farther on along the curve") {
  Waiting waiting;
  waiting.insert(kSites - 1);
  Inserter helper = waiting.inserter.helper();
  CHECK(waiting.inserted_in(helper, kAll) == kWaiting - 1);
}

TEST_CASE("what is barred in one range serves in the next") {
  Waiting waiting;
  waiting.insert(kSites - kWaiting);
  Inserter helper = waiting.inserter.helper();
  // Of all tetrahedra around the one site that was inserted, none is in this range.
  const SiteBlocks few = blocks_of(kSites, kSites - kWaiting, kSites - kWaiting + 1);
  CHECK(waiting.inserted_in(helper, few) == 0);
  CHECK(waiting.inserted_in(helper, kAll) == kWaiting - 1);
}

TEST_CASE("stops when it is told to") {
  Waiting waiting;
  waiting.insert(kSites - 1);
  Inserter helper = waiting.inserter.helper();
  helper.move_to(kAll.range(), waiting.sites);
  const auto few = [](std::size_t tried) { return tried < 10; };
  const auto tally = helper.insert_all(waiting.sites, few);
  CHECK(tally.tried == 10);
  CHECK(tally.inserted == 10);
  CHECK(waiting.sites.count() == kWaiting - 1 - 10);
}

/// Whether its neighbours' ridges lead back to it, as is so while it is part of the hull.
bool is_linked(const Facets& facets, FacetIndex f) {
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Ridge r = facets.neighbors(f)[i];
    if (facets.neighbors(facet_of(r))[corner_of(r)] != ridge(f, i)) return false;
  }
  return true;
}

TEST_CASE("whenever a helper stops, what is known and seems to live does") {
  Waiting waiting;
  waiting.insert(kSites - 1);
  Inserter helper = waiting.inserter.helper();
  helper.move_to(kAll.range(), waiting.sites);
  std::size_t living = 0, wrong = 0;
  const auto one = [](std::size_t tried) { return tried < 1; };
  while (helper.insert_all(waiting.sites, one).inserted > 0) {
    for (const FacetIndex f : waiting.known) {
      if (f == kNone || !waiting.facets.lives(f)) continue;
      ++living;
      wrong += !is_linked(waiting.facets, f);
    }
  }
  CHECK(waiting.sites.count() == 0);
  CHECK(living > kWaiting);
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace tetsculpt::hull
