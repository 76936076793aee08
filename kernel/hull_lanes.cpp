// Four doubles are a vector of GCC's and Clang's extension, the same on all processors; only
// functions for AVX2 are told to use it, and only where has_four_lanes() are they called.
#include "kernel/hull_lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "kernel/four_rows.h"
#include "kernel/hull_region.h"

namespace tetsculpt::hull {
namespace {

/// Per set of lanes, a bit each: their numbers, ahead of the others'.
constexpr auto kFirst = [] {
  std::array<std::array<std::uint32_t, 4>, 16> table{};
  for (unsigned lanes = 0; lanes < 16; ++lanes) {
    std::size_t size = 0;
    for (unsigned i = 0; i < 4; ++i) {
      if ((lanes >> i & 1) != 0) table[lanes][size++] = i;
    }
  }
  return table;
}();

/// Those of four ridges that are in a set of lanes, to the end of a list.
TETSCULPT_FOUR_LANES inline void append(const FourIndices& four, unsigned lanes, Ridge* list,
                                        std::size_t& size) {
  const FourIndices ordered = in_order(four, kFirst[lanes]);
  std::memcpy(list + size, &ordered, sizeof ordered);
  size += static_cast<std::size_t>(std::popcount(lanes));
}

/// Per set of lanes, a byte each: 1 if it is in the set.
constexpr auto kBytes = [] {
  std::array<std::uint32_t, 16> table{};
  for (std::uint32_t lanes = 0; lanes < 16; ++lanes) {
    for (std::uint32_t i = 0; i < 4; ++i) table[lanes] |= (lanes >> i & 1) << 8 * i;
  }
  return table;
}();

/// Whether a box contains four facets.
TETSCULPT_FOUR_LANES inline bool contains_four(const CenterBox& box, const FourRows& normals) {
  auto inside = ~FourLongs{};
  for (std::size_t i = 0; i < CenterBox::kAxes; ++i) {
    const auto& [of_y, of_z] = box.diagonal(i);
    const Four at = normals.x + of_y * normals.y + of_z * normals.z;
    inside &= (at >= box.low(i)) & (at < box.high(i));
  }
  return pattern(inside) == 15;
}

/// How it is decided what is within a range.
enum class By { kNothing, kCorners, kCenters };

template <By kBy>
TETSCULPT_FOUR_LANES bool expand_four(Facets& facets, const LiftedDifference& point,
                                      const Range& range, std::size_t begin, Region& region) {
  const SiteRange own = range.sites();  // nothing that is written could be part of it
  const FourRows queries = four_times(point);
  const auto number = [](Mark mark) { return static_cast<unsigned>(mark); };
  Mark* const marks = &facets.mark(0);
  const Facet* const facet = &facets[0];
  std::size_t visible_size = region.visible.size();
  std::size_t unclear_size = region.unclear.size();
  std::size_t cut_size = region.cut.size();
  for (std::size_t k = begin; k < visible_size;) {
    const std::size_t most = 2 * visible_size + 64;
    Ridge* const visible = region.visible.room_for(most + 4);
    Ridge* const unclear = region.unclear.room_for(unclear_size + 4 * (most - k) + 4);
    Ridge* const cut = region.cut.room_for(cut_size + 4 * (most - k) + 4);
    for (; k < visible_size && visible_size <= most; ++k) {
      const FacetLinks& links = facet[facet_of(visible[k])].links;
      const auto leave = [&] {
        region.visible.hold(visible_size);
        region.unclear.hold(unclear_size);
        return false;
      };
      // Before its links are read, which others may change.
      if (kBy == By::kCorners && !own.contains(links.corners[corner_of(visible[k])])) {
        return leave();
      }
      const auto& [a, b, c, d] = links.neighbors;
      const FourRows normals =
          rows(facet[facet_of(a)], facet[facet_of(b)], facet[facet_of(c)], facet[facet_of(d)]);
      if (kBy == By::kCenters && !contains_four(*range.centers(), normals)) return leave();
      Four value;
      Four error;
      four_heights(normals, queries, value, error);
      Mark& mark_a = marks[facet_of(a)];
      Mark& mark_b = marks[facet_of(b)];
      Mark& mark_c = marks[facet_of(c)];
      Mark& mark_d = marks[facet_of(d)];
      const unsigned known =
          number(mark_a) + 2 * number(mark_b) + 4 * (number(mark_c) + 2 * number(mark_d));
      const FourIndices met = four_of(links.neighbors.data());
      const unsigned sees = pattern(value > error);
      const unsigned hidden = pattern(value < -error);
      const unsigned clear = sees | hidden;
      std::uint32_t bytes = kBytes[sees];
      if (clear != 15) [[unlikely]] {
        append(met, 15 & ~(clear | known >> 4 | known), unclear, unclear_size);
        bytes |= kBytes[15 ^ clear] << 4;
      }
      mark_a = static_cast<Mark>(bytes & 255);
      mark_b = static_cast<Mark>(bytes >> 8 & 255);
      mark_c = static_cast<Mark>(bytes >> 16 & 255);
      mark_d = static_cast<Mark>(bytes >> 24);
      append(met, sees & ~known, visible, visible_size);
      append((visible[k] & ~Ridge{3}) + FourIndices{0, 1, 2, 3}, hidden, cut, cut_size);
    }
  }
  region.visible.hold(visible_size);
  region.unclear.hold(unclear_size);
  region.cut.hold(cut_size);
  return true;
}

}  // namespace

bool has_four_lanes() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
         __builtin_cpu_supports("popcnt") != 0;
#else
  return false;
#endif
}

bool expand(Facets& facets, const LiftedDifference& point, const Range& own, std::size_t begin,
            Region& region) {
  std::size_t visible_size = region.visible.size();
  std::size_t unclear_size = region.unclear.size();
  std::size_t cut_size = region.cut.size();
  for (std::size_t k = begin; k < visible_size; ++k) {
    region.visible.hold(visible_size);
    const Ridge met = region.visible[k];
    const FacetIndex f = facet_of(met);
    const auto owns = [&](Ridge r) { return own.owns(facets[facet_of(r)]); };
    if (own.centers() ? !std::ranges::all_of(facets.neighbors(f), owns)
                      : !own.owns_behind(facets[f], corner_of(met))) {
      return false;
    }
    Ridge* const visible = region.visible.room_for(visible_size + 4);
    Ridge* const unclear = region.unclear.room_for(unclear_size + 4);
    Ridge* const cut = region.cut.room_for(cut_size + 4);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const Ridge r = facets.neighbors(f)[i];
      const Facets::Height h = facets.height(facet_of(r), point);
      Mark& mark = facets.mark(facet_of(r));
      if (h.value < -h.error) {
        cut[cut_size++] = ridge(f, i);
      } else if (mark == Mark::kUnmet) {
        const bool sees = h.value > h.error;
        mark = sees ? Mark::kVisible : Mark::kUnclear;
        (sees ? visible[visible_size++] : unclear[unclear_size++]) = r;
      }
    }
    region.unclear.hold(unclear_size);
  }
  region.cut.hold(cut_size);
  return true;
}

bool expand_by_four(Facets& facets, const LiftedDifference& point, const Range& own,
                    std::size_t begin, Region& region) {
  const auto work = own.centers() ? expand_four<By::kCenters>
                    : own.all()   ? expand_four<By::kNothing>
                                  : expand_four<By::kCorners>;
  return work(facets, point, own, begin, region);
}

TETSCULPT_FOUR_LANES Nearer nearer_by_four(const Facets& facets, FacetIndex f,
                                           const LiftedDifference& q, const Range& own) {
  const FourRows queries = four_times(q);
  const Facet* const facet = &facets[0];
  const bool all_own = own.all();
  Four height = four_times(facets.height(f, q).value);
  for (;;) {
    const auto& ridges = facet[f].links.neighbors;
    Four value;
    Four error;
    four_heights(rows(facet[facet_of(ridges[0])], facet[facet_of(ridges[1])],
                      facet[facet_of(ridges[2])], facet[facet_of(ridges[3])]),
                 queries, value, error);
    const Four of_two = greater(value, __builtin_shufflevector(value, value, 1, 0, 3, 2));
    const Four of_four = greater(of_two, __builtin_shufflevector(of_two, of_two, 2, 3, 0, 1));
    const unsigned highest = pattern(value == of_four);
    const unsigned visible = pattern(value > error);
    const unsigned nearer = pattern(value > height);
    // The highest is far inside what q sees: all of that is met in fewer steps.
    unsigned best = visible & highest;
    if (best == 0) best = visible != 0 ? visible : nearer & highest;
    if (best == 0) return {f, false};
    const Ridge r = ridges[static_cast<std::size_t>(std::countr_zero(best))];
    const FacetIndex g = facet_of(r);
    if (visible != 0) return {g, true};
    if (facet[g].links.infinite()) return {f, false};
    if (!all_own && !own.owns_behind(facet[g], corner_of(r))) return {f, false};
    f = g;
    height = of_four;
  }
}

}  // namespace tetsculpt::hull
