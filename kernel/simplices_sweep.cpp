#include "kernel/simplices_sweep.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "kernel/eight_lanes.h"

namespace tetsculpt::simplices {
namespace {

using hull::EightIndices;
using hull::FourIndices;

/// Takes over the ids that a neighbour has for the edges of their common facet. An edge that has
/// another one already is the same.
inline void take_over(RankedEdges& edges, const std::array<std::uint8_t, 3>& mine,
                      const RankedEdges& known, const std::array<std::uint8_t, 3>& theirs,
                      DisjointSets& same) {
  for (std::size_t m = 0; m < 3; ++m) {
    EdgeId& here = edges[mine[m]];
    const EdgeId other = known[theirs[m]];
    if (here != kNoEdge && here != other) same.unite(+here, +other);
    here = std::min(here, other);
  }
}

/// Per pair of facets, opposite rank r in one tetrahedron and s in another: which of the other's
/// edges each of the first's six is, if it is in the facet.
constexpr auto kTheirs = [] {
  std::array<std::array<std::array<std::uint32_t, 8>, 4>, 4> theirs{};
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t s = 0; s < 4; ++s) {
      for (std::size_t m = 0; m < 3; ++m) theirs[r][s][kFacetEdges[r][m]] = kFacetEdges[s][m];
    }
  }
  return theirs;
}();

/// Per facet, opposite a rank, ones in lanes of edges that are not in it; last, of no facet.
constexpr auto kAbsent = [] {
  std::array<std::array<std::uint32_t, 8>, 5> absent{};
  for (auto& lanes : absent) lanes.fill(0xffffffffu);
  for (std::size_t r = 0; r < 4; ++r) {
    for (const std::uint8_t e : kFacetEdges[r]) absent[r][e] = 0;
  }
  return absent;
}();

/// Per set of lanes, a bit each: how many of the set come before each lane, and which lanes are in
/// it, in order.
template <std::size_t kLanes, class Number, std::size_t kSize>
struct LaneSets {
  std::array<std::array<Number, kSize>, std::size_t{1} << kLanes> before{};
  std::array<std::array<Number, kSize>, std::size_t{1} << kLanes> lanes{};
  constexpr LaneSets() {
    for (std::size_t set = 0; set < before.size(); ++set) {
      std::size_t count = 0;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        before[set][lane] = static_cast<Number>(count);
        if ((set >> lane & 1) != 0) lanes[set][count++] = static_cast<Number>(lane);
      }
    }
  }
};
constexpr LaneSets<4, std::uint32_t, 4> kFacetSets;
constexpr LaneSets<6, std::uint8_t, 8> kEdgeSets;

std::uint32_t raw(TriangleId t) { return static_cast<std::uint32_t>(+t); }

/// What is known of the edges of a tetrahedron in all its facets: the least id and the greatest.
struct Known {
  EightIndices least;
  EightIndices greatest;
};

/// From the facets behind which neighbours were swept, as these see them; others are given as any.
TETSCULPT_FOUR_LANES inline Known known_edges(const Sweep& all, std::uint8_t odd,
                                              const FourIndices& facets, unsigned swept) {
  Known known{~EightIndices{}, EightIndices{}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const FacetHandle f = facets[i];
    const std::size_t mine = rank(i, odd);
    const std::size_t theirs = rank(f & 3, all.odd[f >> 2]);
    const EightIndices row =
        hull::eight_of(reinterpret_cast<const std::uint32_t*>(all.edges_of[f >> 2].data()));
    const EightIndices absent = hull::eight_of(kAbsent[(swept >> i & 1) != 0 ? mine : 4].data());
    const EightIndices edges = hull::in_order(row, hull::eight_of(kTheirs[mine][theirs].data()));
    known.least = hull::lesser(known.least, edges | absent);
    known.greatest = hull::greater(known.greatest, edges & ~absent);
  }
  return known;
}

}  // namespace

void sweep(const Sweep& all, Stretch& stretch, std::uint32_t from, std::uint32_t to) {
  for (std::uint32_t t = from; t < to; ++t) {
    RankedEdges edges;
    edges.fill(kNoEdge);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const FacetHandle h = all.neighbors[t][i];
      const std::uint32_t u = h >> 2;
      if (u >= t) {
        all.facet_of[stretch.next_triangle] = 4 * t + i;
        all.triangles_of[t][i] = TriangleId{stretch.next_triangle++};
      } else if (u >= stretch.begin) {
        all.triangles_of[t][i] = all.triangles_of[u][h & 3];
        take_over(edges, edges_of_facet(4 * t + i, all.odd), all.edges_of[u],
                  edges_of_facet(h, all.odd), all.same);
      } else {
        all.triangles_of[t][i] = kNoTriangle;
        stretch.joints.push_back(4 * t + i);
      }
    }
    for (std::uint32_t k = 0; k < 6; ++k) {
      if (edges[k] != kNoEdge) continue;
      all.made_in[stretch.next_edge] = 6 * t + k;
      edges[k] = EdgeId{stretch.next_edge++};
    }
    all.edges_of[t] = edges;
  }
}

TETSCULPT_FOUR_LANES void sweep_by_eight(const Sweep& all, Stretch& stretch, std::uint32_t from,
                                         std::uint32_t to) {
  constexpr std::uint32_t kAhead = 12;
  const TriangleId* const triangle_at = all.triangles_of->data();  // per facet
  for (std::uint32_t t = from; t < to; ++t) {
    for (const FacetHandle f : all.neighbors[std::min(t + kAhead, to - 1)]) {
      __builtin_prefetch(&all.triangles_of[f >> 2]);
      __builtin_prefetch(&all.edges_of[f >> 2]);
    }
    const FourIndices across = hull::four_of(all.neighbors[t].data());
    const FourIndices other = across >> 2;
    // One by one where there is no facet to take for any, or what is written would reach into
    // another stretch.
    if (t == stretch.begin || t + 1 == stretch.end ||
        stretch.triangles_end - stretch.next_triangle < 4) [[unlikely]] {
      sweep(all, stretch, t, t + 1);
      continue;
    }
    const auto is_before = reinterpret_cast<FourIndices>(other < stretch.begin);
    const auto is_swept = reinterpret_cast<FourIndices>(other < t) & ~is_before;
    const unsigned before = hull::first_bits(is_before);
    const unsigned swept = hull::first_bits(is_swept);
    const unsigned unswept = 15 ^ swept ^ before;
    for (unsigned left = before; left != 0; left &= left - 1) {
      stretch.joints.push_back(4 * t + static_cast<std::uint32_t>(std::countr_zero(left)));
    }
    const FourIndices facets = is_swept ? across : FourIndices{} + 4 * stretch.begin;  // any
    FourIndices taken{};
    for (std::size_t i = 0; i < 4; ++i) taken[i] = raw(triangle_at[facets[i]]);
    const FourIndices made =
        stretch.next_triangle + hull::four_of(kFacetSets.before[unswept].data());
    const FourIndices triangles = (is_swept ? taken : made) | is_before;  // kNoTriangle
    std::memcpy(&all.triangles_of[t], &triangles, sizeof triangles);
    const FourIndices mine = 4 * t + hull::four_of(kFacetSets.lanes[unswept].data());
    std::memcpy(&all.facet_of[stretch.next_triangle], &mine, sizeof mine);
    stretch.next_triangle += static_cast<std::uint32_t>(std::popcount(unswept));

    const Known known = known_edges(all, all.odd[t], facets, swept);
    const auto is_new = reinterpret_cast<EightIndices>(known.least == +kNoEdge);
    const unsigned fresh = hull::first_bits(is_new) & 63;
    const unsigned one =
        hull::first_bits(reinterpret_cast<EightIndices>(known.least == known.greatest));
    const EightIndices ids = stretch.next_edge + hull::eight_of(kEdgeSets.before[fresh]);
    const EightIndices edges = is_new ? ids : known.least;
    // Eight, as they are read. Where a page is read before it is written, the system shows zeros
    // and then has to tell all processors: two threads took 260 ms for a bumpy sphere, 165 like
    // this.
    std::memcpy(static_cast<void*>(&all.edges_of[t]), &edges, sizeof edges);
    const EightIndices places = 6 * t + hull::eight_of(kEdgeSets.lanes[fresh]);
    std::memcpy(&all.made_in[stretch.next_edge], &places, sizeof places);
    stretch.next_edge += static_cast<std::uint32_t>(std::popcount(fresh));
    for (unsigned differ = 63 & ~(fresh | one); differ != 0; differ &= differ - 1) {
      const int k = std::countr_zero(differ);
      all.same.unite(known.least[k], known.greatest[k]);
    }
  }
}

}  // namespace tetsculpt::simplices
