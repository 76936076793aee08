// The set of sites still to be inserted, against a sorted set.
#include "kernel/hull_site_set.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <set>
#include <vector>

namespace tetsculpt::hull {
namespace {

/// Those that each() visits, but no more than `most`.
std::vector<Site> visited(const SiteSet& sites, Site begin, Site end,
                          std::size_t most = std::size_t(-1)) {
  std::vector<Site> seen;
  const bool all = sites.each(begin, end, [&](Site s) {
    if (seen.size() == most) return false;
    seen.push_back(s);
    return true;
  });
  CHECK(all == (seen.size() == sites.count(begin, end)));
  return seen;
}

std::vector<Site> part(const std::set<Site>& sites, Site begin, Site end) {
  return {sites.lower_bound(begin), sites.lower_bound(end)};
}

TEST_CASE("inserted, erased, counted and visited in parts") {
  std::mt19937 random(1);
  for (const Site size : {1u, 63u, 64u, 65u, 1000u}) {
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
    for (Site begin = 0; begin < size; begin += SiteSet::kPerWord) {
      for (Site end = begin; end < size + SiteSet::kPerWord; end += SiteSet::kPerWord) {
        const std::vector<Site> of_part = part(expected, begin, std::min(end, size));
        CHECK(visited(sites, begin, std::min(end, size)) == of_part);
      }
    }
    const std::vector<Site> all = part(expected, 0, size);
    CHECK(
        visited(sites, 0, size, all.size() / 2) ==
        std::vector<Site>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2)));
    std::set<Site> words;
    for (const Site s : all) words.insert(s / SiteSet::kPerWord * SiteSet::kPerWord);
    std::vector<Site> seen_words;
    sites.each_word([&](Site s) { seen_words.push_back(s); });
    CHECK(seen_words == std::vector<Site>(words.begin(), words.end()));
  }
}

TEST_CASE("a site may go while it is visited") {
  SiteSet sites(300);
  for (Site s = 0; s < 300; s += 3) sites.insert(s);
  std::size_t count = 0;
  sites.each(0, 300, [&](Site s) {
    if (s % 2 == 0) sites.erase(s);
    return ++count > 0;
  });
  CHECK(count == 100);
  CHECK(sites.count() == 50);
  CHECK(visited(sites, 0, 64) == std::vector<Site>{3, 9, 15, 21, 27, 33, 39, 45, 51, 57, 63});
}

}  // namespace
}  // namespace tetsculpt::hull
