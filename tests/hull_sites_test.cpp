// The set of sites still to be inserted, against a sorted set.
#include "kernel/hull_sites.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace tetsculpt::hull {
namespace {

/// Those of a block that are visited, but no more than `most`.
std::vector<Site> visited(const SiteSet& sites, std::size_t block, std::size_t most = kBlock) {
  std::vector<Site> seen;
  const bool all = sites.each_in(block, [&](Site s) {
    if (seen.size() == most) return false;
    seen.push_back(s);
    return true;
  });
  CHECK(all == (seen.size() == sites.count_in(block)));
  return seen;
}

TEST_CASE("inserted, erased, counted and visited by block") {
  std::mt19937 random(1);
  for (const std::size_t size : {1u, 15u, 16u, 17u, 1000u}) {
    CAPTURE(size);
    SiteSet sites(size);
    std::set<Site> expected;
    CHECK(sites.count() == 0);
    for (int k = 0; k < 500; ++k) {
      const auto s = static_cast<Site>(random() % size);
      if (random() % 3 == 0) {
        sites.erase(s);
        expected.erase(s);
      } else {
        sites.insert(s);
        expected.insert(s);
      }
      REQUIRE(sites.count() == expected.size());
    }
    CHECK(sites.block_count() == (size - 1) / kBlock + 1);
    for (Site block = 0; block < sites.block_count(); ++block) {
      std::vector<Site> of_block(expected.lower_bound(block * kBlock),
                                 expected.lower_bound(block * kBlock + kBlock));
      CHECK(sites.count_in(block) == of_block.size());
      CHECK(visited(sites, block) == of_block);
      if (of_block.size() > 3) of_block.resize(3);
      CHECK(visited(sites, block, 3) == of_block);
    }
  }
}

TEST_CASE("a site may go while it is visited") {
  SiteSet sites(20);
  for (Site s = 0; s < 20; s += 3) sites.insert(s);
  sites.each_in(0, [&](Site s) {
    if (s % 2 == 0) sites.erase(s);
    return true;
  });
  CHECK(visited(sites, 0) == std::vector<Site>{3, 9, 15});
  CHECK(visited(sites, 1) == std::vector<Site>{18});
}

}  // namespace
}  // namespace tetsculpt::hull
