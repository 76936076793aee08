// Where facets come from: rooms that do not overlap, end with a large page, and count no more once
// they are given back.
#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <vector>

#include "kernel/hull_facets.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using hull::FacetRoom;
using hull::Facets;

const std::vector<Point3>& sites() {
  static const std::vector<Point3> points = point_sets::uniform_cube(10'000, 1);
  return points;
}

TEST_CASE("rooms follow each other and hold what was asked for") {
  Facets facets(sites(), 0);
  std::size_t end = 0;
  for (const std::size_t count : {5u, 1u, 40'000u, 100u, 300'000u}) {
    CAPTURE(count);
    const FacetRoom room = facets.append(count);
    CHECK(room.begin == end);
    CHECK(room.size() >= count);
    end = room.end;
    CHECK(facets.size() == end);
  }
}

TEST_CASE("a new facet is not marked, whatever was there before") {
  Facets facets(sites(), 0);
  const FacetRoom first = facets.append(5);
  for (hull::FacetIndex f = first.begin; f < first.end; ++f) facets.mark(f) = hull::Mark::kVisible;
  facets.give_back({first});
  const FacetRoom again = facets.append(5);
  REQUIRE(again.begin == first.begin);
  std::size_t marked = 0;
  for (hull::FacetIndex f = again.begin; f < again.end; ++f) {
    marked += facets.mark(f) != hull::Mark::kUnmet;
  }
  CHECK(marked == 0);
}

#if __has_include(<sys/mman.h>)
TEST_CASE("two threads' rooms are in different pages of 2 MiB") {
  Facets facets(sites(), 0);
  facets.append(5);
  const auto page = [&](hull::FacetIndex f) {
    return reinterpret_cast<std::size_t>(&facets[f]) >> 21;
  };
  const FacetRoom one = facets.append(1);
  const FacetRoom two = facets.append(1);
  CHECK(page(one.begin) == page(one.end - 1));
  CHECK(page(two.begin) == page(one.end - 1) + 1);
}
#endif

TEST_CASE("no room while shared, more after that") {
  Facets facets(sites(), 0);
  facets.share();
  std::size_t rooms = 0;
  while (facets.append(30'000).size() > 0) ++rooms;
  CHECK(rooms > 1);
  CHECK(facets.full());
  CHECK(facets.append(30'000).size() == 0);
  facets.unshare();
  CHECK_FALSE(facets.full());
  CHECK(facets.append(30'000).size() >= 30'000);
}

TEST_CASE("room that is made ahead is there while shared") {
  Facets facets(sites(), 0);
  const FacetRoom first = facets.append(5);
  facets.corners(first.begin) = {4, 3, 2, 1};
  facets.reserve(1'000'000);
  facets.reserve(5);
  CHECK((facets.corners(first.begin) == std::array<hull::Site, 4>{4, 3, 2, 1}));
  facets.share();
  while (facets.size() + 100'000 <= 1'000'000) REQUIRE(facets.append(30'000).size() > 0);
  CHECK_FALSE(facets.full());
  facets.unshare();
}

TEST_CASE("what is given back is gone at the end and dead elsewhere") {
  Facets facets(sites(), 0);
  const FacetRoom first = facets.append(5);
  FacetRoom between = facets.append(1);
  const FacetRoom used = facets.append(1);
  FacetRoom last = facets.append(1);
  between.begin += 10;
  last.begin += 7;
  facets.give_back({between, last, {used.end, used.end}});
  CHECK(facets.size() == last.begin);
  CHECK_FALSE(facets.lives(between.begin));
  CHECK_FALSE(facets.lives(between.end - 1));
  facets.give_back({{used.begin, last.begin}, {first.begin, between.begin}});
  CHECK(facets.size() == used.begin);
  CHECK_FALSE(facets.lives(first.begin));
}

}  // namespace
}  // namespace tetsculpt
