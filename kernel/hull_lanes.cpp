// Four doubles are a vector of GCC's and Clang's extension, the same on all processors; only
// functions for AVX2 are told to use it, and only where has_four_lanes() are they called.
#include "kernel/hull_lanes.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#define TETSCULPT_FOUR_LANES [[gnu::target("avx2,popcnt")]]
#else
#define TETSCULPT_FOUR_LANES
#endif

namespace tetsculpt::hull {
namespace {

using Four = double __attribute__((vector_size(32)));
using Two = double __attribute__((vector_size(16)));
using FourLongs = std::int64_t __attribute__((vector_size(32)));
using FourBits = std::uint64_t __attribute__((vector_size(32)));

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

/// Four rows of four doubles, a component in each vector.
struct FourRows {
  Four x, y, z, w;
};

/// Two doubles of an object, from the one at that place on.
template <std::size_t kPlace, class T>
TETSCULPT_FOUR_LANES inline Two two_of(const T& object) {
  static_assert(sizeof(T) >= (kPlace + 2) * sizeof(double));
  Two result;
  std::memcpy(&result, reinterpret_cast<const std::byte*>(&object) + kPlace * sizeof(double),
              sizeof result);
  return result;
}

/// No arrays of vectors, here and below: GCC would put them together in memory.
TETSCULPT_FOUR_LANES inline void transpose(Four& a, Four& b, Four& c, Four& d) {
  const Four ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Four ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Four cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

TETSCULPT_FOUR_LANES inline Four joined(const Two& low, const Two& high) {
#if defined(__x86_64__)
  return _mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1);
#else
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
#endif
}

/// Two components of four objects.
template <std::size_t kPlace, class T>
TETSCULPT_FOUR_LANES inline void load_two(const T& a, const T& b, const T& c, const T& d,
                                          Four& first, Four& second) {
  const Four ac = joined(two_of<kPlace>(a), two_of<kPlace>(c));
  const Four bd = joined(two_of<kPlace>(b), two_of<kPlace>(d));
  first = __builtin_shufflevector(ac, bd, 0, 4, 2, 6);
  second = __builtin_shufflevector(ac, bd, 1, 5, 3, 7);
}

/// What four objects begin with.
template <class T>
TETSCULPT_FOUR_LANES inline FourRows rows(const T& a, const T& b, const T& c, const T& d) {
  FourRows result;
  load_two<0>(a, b, c, d, result.x, result.y);
  load_two<2>(a, b, c, d, result.z, result.w);
  return result;
}

/// The same row four times.
TETSCULPT_FOUR_LANES inline FourRows four_times(const LiftedDifference& q) {
  return {q.x - Four{}, q.y - Four{}, q.z - Four{}, q.w - Four{}};
}

TETSCULPT_FOUR_LANES inline Four magnitude(const Four& a) {
  return reinterpret_cast<Four>(reinterpret_cast<FourLongs>(a) &
                                std::numeric_limits<std::int64_t>::max());
}

TETSCULPT_FOUR_LANES inline Four root(const Four& a) {
#if defined(__x86_64__)
  return _mm256_sqrt_pd(a);
#else
  return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

/// A bit per lane that is negative.
TETSCULPT_FOUR_LANES inline unsigned negative(const Four& lanes) {
#if defined(__x86_64__)
  return static_cast<unsigned>(_mm256_movemask_pd(lanes));
#else
  unsigned bits = 0;
  for (unsigned i = 0; i < 4; ++i) bits |= unsigned{std::signbit(lanes[i])} << i;
  return bits;
#endif
}

/// A bit per lane that holds: of a comparison.
template <class Comparison>
TETSCULPT_FOUR_LANES inline unsigned pattern(const Comparison& lanes) {
  return negative(reinterpret_cast<Four>(lanes));
}

/// Those of four indices that are in a set of lanes, to the end of a list.
TETSCULPT_FOUR_LANES inline void append(const FacetIndex* four, unsigned lanes, FacetIndex* list,
                                        std::size_t& size) {
#if defined(__x86_64__)
  __m128 indices;
  __m128i order;
  std::memcpy(&indices, four, sizeof indices);
  std::memcpy(&order, &kFirst[lanes], sizeof order);
  indices = _mm_permutevar_ps(indices, order);
  std::memcpy(list + size, &indices, sizeof indices);
#else
  for (std::size_t i = 0; i < 4; ++i) list[size + i] = four[kFirst[lanes][i]];
#endif
  size += static_cast<std::size_t>(std::popcount(lanes));
}

/// Facets::height, of four facets.
TETSCULPT_FOUR_LANES inline void four_heights(const Facets& facets, FacetIndex a, FacetIndex b,
                                              FacetIndex c, FacetIndex d, const FourRows& q,
                                              Four& value, Four& error) {
  const FourRows n = rows(facets[a], facets[b], facets[c], facets[d]);  // w: the offset
  value = n.x * q.x + n.y * q.y + n.z * q.z + (n.w - q.w);
  error = reinterpret_cast<Four>(reinterpret_cast<FourBits>(n.w) << 52);
}

/// From the apex to one of the corners of four facets.
template <std::size_t kCorner>
TETSCULPT_FOUR_LANES inline FourRows spokes_to_corner(const ConeFacet* four,
                                                      std::span<const Spoke> spokes) {
  return rows(spokes[four[0].numbers[kCorner]], spokes[four[1].numbers[kCorner]],
              spokes[four[2].numbers[kCorner]], spokes[four[3].numbers[kCorner]]);
}

/// Facets::set_hyperplane, of four facets.
TETSCULPT_FOUR_LANES inline void set_four(Facets& facets, const std::array<FacetIndex, 4>& f,
                                          const LiftedDifference& apex, const FourRows& a,
                                          const FourRows& b, const FourRows& c) {
  const Four xy = a.x * b.y - a.y * b.x;
  const Four yz = a.y * b.z - a.z * b.y;
  const Four zx = a.z * b.x - a.x * b.z;
  const Four xw = a.x * b.w - a.w * b.x;
  const Four yw = a.y * b.w - a.w * b.y;
  const Four zw = a.z * b.w - a.w * b.z;
  const Four w = xy * c.z + yz * c.x + zx * c.y;
  const Four size = root(a.w * b.w * c.w);
  const auto infinite = (c.x == 0) & (c.y == 0) & (c.z == 0);
  Four scale = -1 / w;
  if (pattern(infinite) != 0) scale = infinite ? Facets::kInfiniteNormal / size : scale;
  const Facets::ErrorTerms& terms = facets.error_terms();
  const Four growth = Facets::ErrorTerms::kGrowth * (scale * size);
  const auto useful = infinite | ((w < 0) & (growth < 1));
  scale = useful ? scale : Four{};
  Four nx = scale * -(yz * c.w - yw * c.z + zw * c.y);
  Four ny = scale * -(zx * c.w - zw * c.x + xw * c.z);
  Four nz = scale * -(xy * c.w - xw * c.y + yw * c.x);
  Four square = nx * nx + ny * ny + nz * nz;
  square = (square < terms.square) & ~infinite ? square : terms.square - Four{};
  nx = nx + 2 * apex.x;
  ny = ny + 2 * apex.y;
  nz = nz + 2 * apex.z;
  Four offset = apex.w - (nx * apex.x + ny * apex.y + nz * apex.z);
  const Four l1_norm = magnitude(nx) + magnitude(ny) + magnitude(nz);
  const Four local = useful ? growth * square : Facets::ErrorTerms::kUseless - Four{};
  const Four error = local + (terms.linear * l1_norm + terms.constant);
  const FourBits exponent = (reinterpret_cast<FourBits>(error) >> 52) + 1;
  offset = reinterpret_cast<Four>((reinterpret_cast<FourBits>(offset) & ~std::uint64_t{0xfff}) |
                                  exponent);
  transpose(nx, ny, nz, offset);
  facets.set_hyperplane(f[0], &nx);
  facets.set_hyperplane(f[1], &ny);
  facets.set_hyperplane(f[2], &nz);
  facets.set_hyperplane(f[3], &offset);
}

}  // namespace

bool has_four_lanes() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("popcnt") != 0;
#else
  return false;
#endif
}

Counts sort_by_view(const Facets& facets, std::span<const FacetIndex> list,
                    const LiftedDifference& q, FacetIndex* visible, FacetIndex* unclear) {
  Counts counts{};
  for (const FacetIndex f : list) {
    const Facets::Height h = facets.height(f, q);
    const bool sees = h.value > h.error;
    visible[counts.visible] = f;
    counts.visible += sees;
    unclear[counts.unclear] = f;
    counts.unclear += !sees && !(h.value < -h.error);
  }
  return counts;
}

TETSCULPT_FOUR_LANES Counts sort_by_view_by_four(const Facets& facets,
                                                 std::span<const FacetIndex> list,
                                                 const LiftedDifference& q, FacetIndex* visible,
                                                 FacetIndex* unclear) {
  Counts counts{};
  const FourRows queries = four_times(q);
  unsigned sees = 0;
  unsigned open = 0;
  for (std::size_t k = 0; k < list.size(); k += 4) {
    const FacetIndex* const four = &list[k];
    Four value;
    Four error;
    four_heights(facets, four[0], four[1], four[2], four[3], queries, value, error);
    open = 15 & ~pattern(magnitude(value) > error);
    sees = 15 & ~(open | negative(value));
    append(four, sees, visible, counts.visible);
    if (open != 0) [[unlikely]]
      append(four, open, unclear, counts.unclear);
  }
  const unsigned after_end = 15u << ((list.size() - 1) % 4 + 1);
  counts.visible -= static_cast<std::size_t>(std::popcount(sees & after_end));
  counts.unclear -= static_cast<std::size_t>(std::popcount(open & after_end));
  return counts;
}

NeighborHeights neighbor_heights(const Facets& facets, FacetIndex f, const LiftedDifference& q) {
  NeighborHeights heights{};
  for (unsigned i = 0; i < 4; ++i) {
    const Facets::Height h = facets.height(facet_of(facets.neighbors(f)[i]), q);
    heights.value[i] = h.value;
    heights.visible |= unsigned{h.value > h.error} << i;
  }
  return heights;
}

TETSCULPT_FOUR_LANES NeighborHeights neighbor_heights_by_four(const Facets& facets, FacetIndex f,
                                                              const LiftedDifference& q) {
  Four value;
  Four error;
  const auto& ridges = facets.neighbors(f);
  four_heights(facets, facet_of(ridges[0]), facet_of(ridges[1]), facet_of(ridges[2]),
               facet_of(ridges[3]), four_times(q), value, error);
  NeighborHeights heights;
  std::memcpy(&heights.value, &value, sizeof value);
  heights.visible = pattern(value > error);
  return heights;
}

void set_spokes(std::span<const Point3> points, Site apex, std::span<const Site> corners,
                Spoke* spokes) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    spokes[k] = lifted_difference(points[corners[k]], points[apex]);
  }
}

TETSCULPT_FOUR_LANES void set_spokes_by_four(std::span<const Point3> points, Site apex,
                                             std::span<const Site> corners, Spoke* spokes) {
  const Point3 p = points[apex];
  for (std::size_t k = 0; k < corners.size(); k += 4) {
    const Point3& p0 = points[corners[k]];
    const Point3& p1 = points[corners[k + 1]];
    const Point3& p2 = points[corners[k + 2]];
    const Point3& p3 = points[corners[k + 3]];
    Four x;
    Four y;
    load_two<0>(p0, p1, p2, p3, x, y);
    x = x - p.x;
    y = y - p.y;
    Four z = Four{p0.z, p1.z, p2.z, p3.z} - p.z;
    Four w = x * x + y * y + z * z;
    transpose(x, y, z, w);
    std::memcpy(&spokes[k], &x, sizeof x);
    std::memcpy(&spokes[k + 1], &y, sizeof y);
    std::memcpy(&spokes[k + 2], &z, sizeof z);
    std::memcpy(&spokes[k + 3], &w, sizeof w);
  }
}

void set_hyperplanes(Facets& facets, Site apex, std::span<const ConeFacet> cone,
                     std::span<const Spoke> spokes) {
  const LiftedDifference p = facets.lifted(facets.point(apex));
  for (const auto& [f, numbers] : cone) {
    facets.set_hyperplane(f, p, spokes[numbers[0]], spokes[numbers[1]], spokes[numbers[2]]);
  }
}

TETSCULPT_FOUR_LANES void set_hyperplanes_by_four(Facets& facets, Site apex,
                                                  std::span<const ConeFacet> cone,
                                                  std::span<const Spoke> spokes) {
  const LiftedDifference p = facets.lifted(facets.point(apex));
  for (std::size_t k = 0; k < cone.size(); k += 4) {
    const ConeFacet* const four = &cone[k];
    set_four(facets, {four[0].facet, four[1].facet, four[2].facet, four[3].facet}, p,
             spokes_to_corner<0>(four, spokes), spokes_to_corner<1>(four, spokes),
             spokes_to_corner<2>(four, spokes));
  }
}

}  // namespace tetsculpt::hull
