#include "kernel/hull_bucket.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "kernel/four_lanes.h"
#include "kernel/large_array.h"
#include "kernel/radix_sort.h"

namespace tetsculpt::hull {
namespace {

/// How four corners are put in ascending order, infinity last; the last two change places if that
/// keeps the orientation.
struct Order {
  std::array<std::uint32_t, 4> corner_at{};  ///< per place
  std::array<std::uint32_t, 4> place_of{};   ///< per corner
};

/// Six bits: of corners 1 0, 2 0, 3 0, 2 1, 3 1 and 3 2, whether the first is less.
constexpr std::uint32_t compare(const std::array<Site, 4>& c) {
  std::uint32_t bits = c[3] < c[2];
  bits += bits + (c[3] < c[1]);
  bits += bits + (c[2] < c[1]);
  bits += bits + (c[3] < c[0]);
  bits += bits + (c[2] < c[0]);
  bits += bits + (c[1] < c[0]);
  return bits;
}

TETSCULPT_FOUR_LANES inline std::uint32_t compare_by_four(const FourIndices& c) {
  const FourIndices with_first =
      __builtin_shufflevector(c, c, 0, 0, 0, 1) > __builtin_shufflevector(c, c, 1, 2, 3, 2);
  const FourIndices with_last = c > __builtin_shufflevector(c, c, 3, 3, 3, 3);
  return first_bits(with_first) | (first_bits(with_last) & 6) << 3;
}

constexpr auto kOrders = [] {
  std::array<Order, 64> orders{};
  std::array<Site, 4> rank{0, 1, 2, 3};
  do {
    const std::uint32_t bits = compare(rank);
    const auto odd = static_cast<std::uint32_t>(std::popcount(bits)) & 1;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t place = rank[i] ^ (odd & rank[i] >> 1);
      orders[bits].place_of[i] = place;
      orders[bits].corner_at[place] = i;
    }
  } while (std::next_permutation(rank.begin(), rank.end()));
  return orders;
}();

/// A tetrahedron without a place in its bucket.
struct Tet {
  std::array<Site, 4> corners;
  std::uint32_t order;  ///< in kOrders
};

/// Sorts a bucket: no two tetrahedra have the same first three corners, because those around an
/// edge, as they are oriented, lead from each third corner to one fourth.
std::uint64_t key(const std::array<Site, 4>& corners) {
  return std::uint64_t{corners[1]} << 32 | corners[2];
}

/// So many are sorted by counting, four keys at a time.
constexpr std::uint32_t kFew = 64;
using Keys = std::array<std::uint64_t, kFew>;
using Tets = std::array<Tet, kFew>;

/// What is needed so many steps later is asked for: it lies anywhere in memory.
const FacetLinks& listed(const FacetLinks* facets, std::span<const FacetIndex> list,
                         std::uint32_t i) {
  constexpr std::size_t kAhead = 16;
  __builtin_prefetch(&facets[list[std::min(i + kAhead, list.size() - 1)]], 1);
  return facets[list[i]];
}

/// How a tetrahedron is put in order and in its place.
struct OneByOne {
  static Tet ordered(const FacetLinks& facet) {
    Tet tet;
    tet.order = compare(facet.corners);
    const Order& order = kOrders[tet.order];
    for (std::size_t p = 0; p < 4; ++p) tet.corners[p] = facet.corners[order.corner_at[p]];
    return tet;
  }
  /// How many keys come before one: no branch depends on the order they are in.
  static std::uint32_t rank(const Keys& keys, std::uint32_t size, std::uint64_t key) {
    std::uint32_t before = 0;
    for (std::uint32_t k = 0; k < size; ++k) before += keys[k] < key;
    return before;
  }
  static void put(const Tet& tet, FacetLinks& facet, std::uint32_t at, LiftedHull& hull) {
    const Order& order = kOrders[tet.order];
    for (std::size_t p = 0; p < 4; ++p) {
      hull.tets[at][p] = VertexId{tet.corners[p]};
      hull.neighbors[at][p] = facet.neighbors[order.corner_at[p]];
    }
    for (std::size_t i = 0; i < 4; ++i) facet.corners[i] = 4 * at + order.place_of[i];
  }
};

/// The same four corners or keys at a time; reads keys up to a multiple of four.
struct ByFour {
  TETSCULPT_FOUR_LANES static Tet ordered(const FacetLinks& facet) {
    const FourIndices corners = four_of(facet.corners.data());
    Tet tet;
    tet.order = compare_by_four(corners);
    const FourIndices in_places = in_order(corners, kOrders[tet.order].corner_at);
    std::memcpy(&tet.corners, &in_places, sizeof in_places);
    return tet;
  }
  TETSCULPT_FOUR_LANES static std::uint32_t rank(const Keys& keys, std::uint32_t size,
                                                 std::uint64_t key) {
    FourLongs before{};
    for (std::uint32_t k = 0; k < size; k += 4) {
      FourLongs four;
      std::memcpy(&four, &keys[k], sizeof four);
      before += four < static_cast<std::int64_t>(key);  // -1 where it holds
    }
    return static_cast<std::uint32_t>(-(before[0] + before[1] + before[2] + before[3]));
  }
  TETSCULPT_FOUR_LANES static void put(const Tet& tet, FacetLinks& facet, std::uint32_t at,
                                       LiftedHull& hull) {
    const Order& order = kOrders[tet.order];
    std::memcpy(&hull.tets[at], &tet.corners, sizeof tet.corners);
    const FourIndices neighbors = in_order(four_of(facet.neighbors.data()), order.corner_at);
    std::memcpy(&hull.neighbors[at], &neighbors, sizeof neighbors);
    const FourIndices handles = 4 * at + four_of(order.place_of.data());
    std::memcpy(&facet.corners, &handles, sizeof handles);
  }
};

void write_large_bucket(FacetLinks* facets, std::span<const FacetIndex> list, std::uint32_t begin,
                        std::uint32_t end, LiftedHull& hull) {
  LargeArray<KeyedIndex> order(end - begin);
  for (std::uint32_t i = begin; i < end; ++i) {
    order[i - begin] = {key(OneByOne::ordered(listed(facets, list, i)).corners), i};
  }
  radix_sort(order);
  for (std::uint32_t i = begin; i < end; ++i) {
    FacetLinks& facet = facets[list[order[i - begin].index]];
    OneByOne::put(OneByOne::ordered(facet), facet, i, hull);
  }
}

/// Always inline: within what it is called from it may take four lanes.
template <class Way>
[[gnu::always_inline]] inline void write(FacetLinks* facets, std::span<const FacetIndex> list,
                                         std::uint32_t begin, std::uint32_t end, LiftedHull& hull) {
  const std::uint32_t size = end - begin;
  if (size > kFew) return write_large_bucket(facets, list, begin, end, hull);
  Keys keys;
  Tets tets;
  for (std::uint32_t i = 0; i < size; ++i) {
    tets[i] = Way::ordered(listed(facets, list, begin + i));
    keys[i] = key(tets[i].corners);
  }
  for (std::uint32_t i = size; i % 4 != 0; ++i) keys[i] = std::numeric_limits<std::int64_t>::max();
  for (std::uint32_t i = 0; i < size; ++i) {
    Way::put(tets[i], facets[list[begin + i]], begin + Way::rank(keys, size, keys[i]), hull);
  }
}

}  // namespace

void write_bucket(FacetLinks* facets, std::span<const FacetIndex> list, std::uint32_t begin,
                  std::uint32_t end, LiftedHull& hull) {
  write<OneByOne>(facets, list, begin, end, hull);
}

TETSCULPT_FOUR_LANES void write_bucket_by_four(FacetLinks* facets, std::span<const FacetIndex> list,
                                               std::uint32_t begin, std::uint32_t end,
                                               LiftedHull& hull) {
  write<ByFour>(facets, list, begin, end, hull);
}

}  // namespace tetsculpt::hull
