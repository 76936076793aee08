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

#include "kernel/hull_region.h"

namespace tetsculpt::hull {
namespace {

using Two = double __attribute__((vector_size(16)));

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

/// The same number, or the same row, four times.
TETSCULPT_FOUR_LANES inline Four four_times(double number) { return number - Four{}; }
TETSCULPT_FOUR_LANES inline FourRows four_times(const LiftedDifference& q) {
  return {four_times(q.x), four_times(q.y), four_times(q.z), four_times(q.w)};
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

/// a b + c, rounded once where the processor can.
TETSCULPT_FOUR_LANES inline Four fused(const Four& a, const Four& b, const Four& c) {
#if defined(__x86_64__)
  return _mm256_fmadd_pd(a, b, c);
#else
  return a * b + c;
#endif
}

/// a b - c d.
TETSCULPT_FOUR_LANES inline Four minor(const Four& a, const Four& b, const Four& c, const Four& d) {
#if defined(__x86_64__)
  return _mm256_fmsub_pd(a, b, c * d);
#else
  return a * b - c * d;
#endif
}

/// A bit per lane that holds: of a comparison.
template <class Comparison>
TETSCULPT_FOUR_LANES inline unsigned pattern(const Comparison& lanes) {
  return first_bits(reinterpret_cast<Four>(lanes));
}

/// Those of four ridges that are in a set of lanes, to the end of a list.
TETSCULPT_FOUR_LANES inline void append(const FourIndices& four, unsigned lanes, Ridge* list,
                                        std::size_t& size) {
  const FourIndices ordered = in_order(four, kFirst[lanes]);
  std::memcpy(list + size, &ordered, sizeof ordered);
  size += static_cast<std::size_t>(std::popcount(lanes));
}

/// Facets::height, of four facets.
TETSCULPT_FOUR_LANES inline void four_heights(const Facet& a, const Facet& b, const Facet& c,
                                              const Facet& d, const FourRows& q, Four& value,
                                              Four& error) {
  const FourRows n = rows(a, b, c, d);  // w: the offset
  value = fused(n.x, q.x, fused(n.y, q.y, fused(n.z, q.z, n.w - q.w)));
  error = reinterpret_cast<Four>(reinterpret_cast<FourBits>(n.w) << 52);
}

/// Per set of lanes, a byte each: 1 if it is in the set.
constexpr auto kBytes = [] {
  std::array<std::uint32_t, 16> table{};
  for (std::uint32_t lanes = 0; lanes < 16; ++lanes) {
    for (std::uint32_t i = 0; i < 4; ++i) table[lanes] |= (lanes >> i & 1) << 8 * i;
  }
  return table;
}();

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
  const Four xy = minor(a.x, b.y, a.y, b.x);
  const Four yz = minor(a.y, b.z, a.z, b.y);
  const Four zx = minor(a.z, b.x, a.x, b.z);
  const Four xw = minor(a.x, b.w, a.w, b.x);
  const Four yw = minor(a.y, b.w, a.w, b.y);
  const Four zw = minor(a.z, b.w, a.w, b.z);
  const Four w = fused(xy, c.z, fused(yz, c.x, zx * c.y));
  const Four size = root(a.w * b.w * c.w);
  const auto infinite = (c.x == 0) & (c.y == 0) & (c.z == 0);
  const bool any_infinite = pattern(infinite) != 0;
  Four scale = 1 / w;
  if (any_infinite) scale = infinite ? -Facets::kInfiniteNormal / size : scale;
  const Facets::ErrorTerms& terms = facets.error_terms();
  const Four limit = four_times(terms.square);
  const Four growth = -Facets::ErrorTerms::kGrowth * (scale * size);
  auto useful = (w < 0) & (growth < 1);
  if (any_infinite) useful |= infinite;
  scale = useful ? scale : Four{};
  Four nx = scale * fused(yz, c.w, minor(zw, c.y, yw, c.z));
  Four ny = scale * fused(zx, c.w, minor(xw, c.z, zw, c.x));
  Four nz = scale * fused(xy, c.w, minor(yw, c.x, xw, c.y));
  Four square = fused(nx, nx, fused(ny, ny, nz * nz));
  square = square < limit ? square : limit;
  if (any_infinite) square = infinite ? limit : square;
  nx = nx + 2 * apex.x;
  ny = ny + 2 * apex.y;
  nz = nz + 2 * apex.z;
  const FourRows p = four_times(apex);
  Four offset = fused(-p.x, nx, fused(-p.y, ny, fused(-p.z, nz, p.w)));
  const Four l1_norm = magnitude(nx) + magnitude(ny) + magnitude(nz);
  const Four rounded = fused(four_times(terms.linear), l1_norm, four_times(terms.constant));
  Four error = fused(growth, square, rounded);
  error = useful ? error : four_times(Facets::ErrorTerms::kUseless);
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
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
         __builtin_cpu_supports("popcnt") != 0;
#else
  return false;
#endif
}

bool expand(Facets& facets, const LiftedDifference& point, const SiteRange& own, std::size_t begin,
            Region& region) {
  std::size_t visible_size = region.visible.size();
  std::size_t unclear_size = region.unclear.size();
  std::size_t cut_size = region.cut.size();
  for (std::size_t k = begin; k < visible_size; ++k) {
    region.visible.hold(visible_size);
    const FacetIndex f = facet_of(region.visible[k]);
    if (!own.contains(facets.corners(f))) return false;
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

TETSCULPT_FOUR_LANES bool expand_by_four(Facets& facets, const LiftedDifference& point,
                                         const SiteRange& own, std::size_t begin, Region& region) {
  const FourRows queries = four_times(point);
  const bool all_own = own.all();
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
      const FacetIndex f = facet_of(visible[k]);
      const FacetLinks& links = facet[f].links;
      if (!all_own && !own.contains(links.corners)) {
        region.visible.hold(visible_size);
        region.unclear.hold(unclear_size);
        return false;
      }
      const auto& [a, b, c, d] = links.neighbors;
      Four value;
      Four error;
      four_heights(facet[facet_of(a)], facet[facet_of(b)], facet[facet_of(c)], facet[facet_of(d)],
                   queries, value, error);
      Mark& mark_a = marks[facet_of(a)];
      Mark& mark_b = marks[facet_of(b)];
      Mark& mark_c = marks[facet_of(c)];
      Mark& mark_d = marks[facet_of(d)];
      const unsigned known =
          number(mark_a) + 2 * number(mark_b) + 4 * (number(mark_c) + 2 * number(mark_d));
      const FourIndices met = four_of(links.neighbors.data());
      const unsigned clear = pattern(magnitude(value) > error);
      const unsigned hidden = clear & first_bits(value);
      const unsigned sees = clear ^ hidden;
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
  four_heights(facets[facet_of(ridges[0])], facets[facet_of(ridges[1])],
               facets[facet_of(ridges[2])], facets[facet_of(ridges[3])], four_times(q), value,
               error);
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
