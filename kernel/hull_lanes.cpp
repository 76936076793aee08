// Four doubles are a vector of GCC's and Clang's extension, the same on all processors; only
// functions for AVX2 are told to use it, and only where has_four_lanes() are they called.
#include "kernel/hull_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#define TETSCULPT_FOUR_LANES [[gnu::target("avx2")]]
#else
#define TETSCULPT_FOUR_LANES
#endif

namespace tetsculpt::hull {
namespace {

using Four = double __attribute__((vector_size(32)));
using Two = double __attribute__((vector_size(16)));
using FourLongs = std::int64_t __attribute__((vector_size(32)));
using FourFloats = float __attribute__((vector_size(16)));
using FourWords = std::uint32_t __attribute__((vector_size(16)));

/// Spokes, a component in each vector.
struct FourSpokes {
  Four x, y, z, w, length;
};

TETSCULPT_FOUR_LANES inline Four row(const LiftedDifference& d) {
  Four result;
  std::memcpy(&result, &d, sizeof result);
  return result;
}

/// What an object begins with.
template <class T>
TETSCULPT_FOUR_LANES inline Two first_two(const T& object) {
  Two result;
  std::memcpy(&result, &object, sizeof result);
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

TETSCULPT_FOUR_LANES inline void load(const Spoke& a, const Spoke& b, const Spoke& c,
                                      const Spoke& d, FourSpokes& to) {
  to.x = row(a.to);
  to.y = row(b.to);
  to.z = row(c.to);
  to.w = row(d.to);
  transpose(to.x, to.y, to.z, to.w);
  to.length = Four{a.length, b.length, c.length, d.length};
}

/// The first two components of four objects.
template <class T>
TETSCULPT_FOUR_LANES inline void load_two(const T& a, const T& b, const T& c, const T& d,
                                          Four& first, Four& second) {
  const Four ac = __builtin_shufflevector(first_two(a), first_two(c), 0, 1, 2, 3);
  const Four bd = __builtin_shufflevector(first_two(b), first_two(d), 0, 1, 2, 3);
  first = __builtin_shufflevector(ac, bd, 0, 4, 2, 6);
  second = __builtin_shufflevector(ac, bd, 1, 5, 3, 7);
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

/// A bit per lane that holds.
TETSCULPT_FOUR_LANES inline std::uint8_t pattern(const FourLongs& lanes) {
#if defined(__x86_64__)
  return static_cast<std::uint8_t>(_mm256_movemask_pd(reinterpret_cast<Four>(lanes)));
#else
  return static_cast<std::uint8_t>((lanes[0] & 1) | (lanes[1] & 2) | (lanes[2] & 4) |
                                   (lanes[3] & 8));
#endif
}

/// Facets::height, of four facets.
TETSCULPT_FOUR_LANES inline void four_heights(const Facets& facets, FacetIndex a, FacetIndex b,
                                              FacetIndex c, FacetIndex d, const Point3& q,
                                              Four& value, Four& error) {
  const Facet& f0 = facets[a];
  const Facet& f1 = facets[b];
  const Facet& f2 = facets[c];
  const Facet& f3 = facets[d];
  const Point3& p0 = facets.point(f0.links.corners[0]);
  const Point3& p1 = facets.point(f1.links.corners[0]);
  const Point3& p2 = facets.point(f2.links.corners[0]);
  const Point3& p3 = facets.point(f3.links.corners[0]);
  const FourWords bits{f0.error.bits(), f1.error.bits(), f2.error.bits(), f3.error.bits()};
  const Four square =
      __builtin_convertvector(reinterpret_cast<FourFloats>(bits & 0xffff0000u), Four);
  const Four linear = __builtin_convertvector(reinterpret_cast<FourFloats>(bits << 16), Four);
  Four x;
  Four y;
  load_two(p0, p1, p2, p3, x, y);
  x = q.x - x;
  y = q.y - y;
  const Four z = q.z - Four{p0.z, p1.z, p2.z, p3.z};
  const Four w = square == 0 ? Four{} : x * x + y * y + z * z;
  Four nx;
  Four ny;
  load_two(f0, f1, f2, f3, nx, ny);
  value = nx * x + ny * y + Four{f0.nz, f1.nz, f2.nz, f3.nz} * z - w;
  const Four l1_norm = magnitude(x) + magnitude(y) + magnitude(z);
  error = square * w + linear * (l1_norm * facets.reach());
}

/// Facets::set_hyperplane for facets of which none is infinite.
TETSCULPT_FOUR_LANES inline void set_four(Facets& facets, const std::array<FacetIndex, 4>& f,
                                          const FourSpokes& a, const FourSpokes& b,
                                          const FourSpokes& c) {
  const Four xy = a.x * b.y - a.y * b.x;
  const Four yz = a.y * b.z - a.z * b.y;
  const Four zx = a.z * b.x - a.x * b.z;
  const Four xw = a.x * b.w - a.w * b.x;
  const Four yw = a.y * b.w - a.w * b.y;
  const Four zw = a.z * b.w - a.w * b.z;
  const Four w = xy * c.z + yz * c.x + zx * c.y;
  const auto good = w < 0;
  const Four scale = good ? -1 / w : Four{};
  Four nx = scale * -(yz * c.w - yw * c.z + zw * c.y);
  Four ny = scale * -(zx * c.w - zw * c.x + xw * c.z);
  Four nz = scale * -(xy * c.w - xw * c.y + yw * c.x);
  const Four infinite = HUGE_VAL - Four{};
  const Four square =
      good ? ErrorFactors::kRoundings * scale * (a.length * b.length * c.length) : infinite;
  const Four linear = square * ((a.length + b.length + c.length) * facets.per_reach());
  const FourWords high =
      reinterpret_cast<FourWords>(__builtin_convertvector(square, FourFloats)) + 0x10000u;
  const FourWords low =
      reinterpret_cast<FourWords>(__builtin_convertvector(linear, FourFloats)) + 0x10000u;
  const FourWords bits = (high & 0xffff0000u) | low >> 16;
  // A row is a facet as far as its mark, which is none.
  Four last = reinterpret_cast<Four>(__builtin_convertvector(bits, FourLongs));
  transpose(nx, ny, nz, last);
  facets.set_hyperplane(f[0], &nx);
  facets.set_hyperplane(f[1], &ny);
  facets.set_hyperplane(f[2], &nz);
  facets.set_hyperplane(f[3], &last);
}

}  // namespace

bool has_four_lanes() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

void see(const Facets& facets, std::span<const FacetIndex> list, const Point3& q, Seen* seen) {
  for (std::size_t k = 0; k < list.size(); k += 4) {
    unsigned visible = 0;
    unsigned unclear = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const Facets::Height h = facets.height(list[k + i], q);
      const bool sees = h.value > h.error;
      visible |= unsigned{sees} << i;
      unclear |= unsigned{!sees && !(h.value < -h.error)} << i;
    }
    seen[k / 4] = {static_cast<std::uint8_t>(visible), static_cast<std::uint8_t>(unclear)};
  }
}

TETSCULPT_FOUR_LANES void see_by_four(const Facets& facets, std::span<const FacetIndex> list,
                                      const Point3& q, Seen* seen) {
  for (std::size_t k = 0; k < list.size(); k += 4) {
    Four value;
    Four error;
    four_heights(facets, list[k], list[k + 1], list[k + 2], list[k + 3], q, value, error);
    const auto visible = value > error;
    const auto clear = visible | (value < -error);
    seen[k / 4] = {pattern(visible), pattern(~clear)};
  }
}

NeighborHeights neighbor_heights(const Facets& facets, FacetIndex f, const Point3& q) {
  NeighborHeights heights{};
  for (unsigned i = 0; i < 4; ++i) {
    const Facets::Height h = facets.height(facet_of(facets.neighbors(f)[i]), q);
    heights.value[i] = h.value;
    heights.visible |= unsigned{h.value > h.error} << i;
  }
  return heights;
}

TETSCULPT_FOUR_LANES NeighborHeights neighbor_heights_by_four(const Facets& facets, FacetIndex f,
                                                              const Point3& q) {
  Four value;
  Four error;
  const auto& ridges = facets.neighbors(f);
  four_heights(facets, facet_of(ridges[0]), facet_of(ridges[1]), facet_of(ridges[2]),
               facet_of(ridges[3]), q, value, error);
  NeighborHeights heights;
  std::memcpy(&heights.value, &value, sizeof value);
  heights.visible = pattern(value > error);
  return heights;
}

void set_spokes(std::span<const Point3> points, Site apex, std::span<const Site> corners,
                Spoke* spokes) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    spokes[k] = spoke(points[corners[k]], points[apex]);
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
    load_two(p0, p1, p2, p3, x, y);
    x = x - p.x;
    y = y - p.y;
    Four z = Four{p0.z, p1.z, p2.z, p3.z} - p.z;
    Four w = x * x + y * y + z * z;
    const Four length = root(w);
    transpose(x, y, z, w);
    std::memcpy(&spokes[k].to, &x, sizeof x);
    std::memcpy(&spokes[k + 1].to, &y, sizeof y);
    std::memcpy(&spokes[k + 2].to, &z, sizeof z);
    std::memcpy(&spokes[k + 3].to, &w, sizeof w);
    for (std::size_t i = 0; i < 4; ++i) spokes[k + i].length = length[i];
  }
}

void set_hyperplanes(Facets& facets, std::span<const ConeFacet> cone,
                     std::span<const Spoke> spokes) {
  for (const auto& [f, numbers] : cone) {
    facets.set_hyperplane(f, &spokes[numbers[0]], &spokes[numbers[1]],
                          facets.infinite(f) ? nullptr : &spokes[numbers[2]]);
  }
}

TETSCULPT_FOUR_LANES void set_hyperplanes_by_four(Facets& facets, std::span<const ConeFacet> cone,
                                                  std::span<const Spoke> spokes) {
  for (std::size_t k = 0; k < cone.size(); k += 4) {
    std::array<const ConeFacet*, 4> g;  // the last again, where there are no more
    std::array<FacetIndex, 4> f;
    for (std::size_t i = 0; i < 4; ++i) {
      g[i] = &cone[std::min(k + i, cone.size() - 1)];
      f[i] = g[i]->facet;
    }
    if (facets.infinite(f[0]) || facets.infinite(f[1]) || facets.infinite(f[2]) ||
        facets.infinite(f[3])) {
      set_hyperplanes(facets, cone.subspan(k, std::min<std::size_t>(4, cone.size() - k)), spokes);
      continue;
    }
    FourSpokes a;
    FourSpokes b;
    FourSpokes c;
    const auto spoke = [&](std::size_t i, std::size_t corner) -> const Spoke& {
      return spokes[g[i]->numbers[corner]];
    };
    load(spoke(0, 0), spoke(1, 0), spoke(2, 0), spoke(3, 0), a);
    load(spoke(0, 1), spoke(1, 1), spoke(2, 1), spoke(3, 1), b);
    load(spoke(0, 2), spoke(1, 2), spoke(2, 2), spoke(3, 2), c);
    set_four(facets, f, a, b, c);
  }
}

}  // namespace tetsculpt::hull
