// Four doubles are a vector of GCC's and Clang's extension, the same on all processors; only
// functions for AVX2 are told to use it, and only where has_four_lanes() are they called.
//
// All four neighbours of a facet are looked at, although two in five are known already: that costs
// less than to find out which.
#include "kernel/hull_lanes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#if defined(__x86_64__)
#define TETSCULPT_FOUR_LANES [[gnu::target("avx2")]]
#else
#define TETSCULPT_FOUR_LANES
#endif

namespace tetsculpt::hull {
namespace {

using Four = double __attribute__((vector_size(32)));
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

/// No arrays of vectors, here and below: GCC would put them together in memory.
TETSCULPT_FOUR_LANES inline void load(const Spoke& a, const Spoke& b, const Spoke& c,
                                      const Spoke& d, FourSpokes& to) {
  const Four ra = row(a.to);
  const Four rb = row(b.to);
  const Four rc = row(c.to);
  const Four rd = row(d.to);
  const Four xz_ab = __builtin_shufflevector(ra, rb, 0, 4, 2, 6);
  const Four yw_ab = __builtin_shufflevector(ra, rb, 1, 5, 3, 7);
  const Four xz_cd = __builtin_shufflevector(rc, rd, 0, 4, 2, 6);
  const Four yw_cd = __builtin_shufflevector(rc, rd, 1, 5, 3, 7);
  to.x = __builtin_shufflevector(xz_ab, xz_cd, 0, 1, 4, 5);
  to.y = __builtin_shufflevector(yw_ab, yw_cd, 0, 1, 4, 5);
  to.z = __builtin_shufflevector(xz_ab, xz_cd, 2, 3, 6, 7);
  to.w = __builtin_shufflevector(yw_ab, yw_cd, 2, 3, 6, 7);
  to.length = Four{a.length, b.length, c.length, d.length};
}

TETSCULPT_FOUR_LANES inline Four magnitude(const Four& a) { return a < 0 ? -a : a; }

/// A bit per lane that holds.
template <class Lanes>
TETSCULPT_FOUR_LANES inline std::uint8_t pattern(const Lanes& lanes) {
  return static_cast<std::uint8_t>((lanes[0] & 1) | (lanes[1] & 2) | (lanes[2] & 4) |
                                   (lanes[3] & 8));
}

/// Facets::height of a facet's neighbours.
TETSCULPT_FOUR_LANES inline void four_heights(const Facets& facets,
                                              const std::array<Ridge, 4>& ridges, const Point3& q,
                                              Four& value, Four& error) {
  const Facet& f0 = facets[facet_of(ridges[0])];
  const Facet& f1 = facets[facet_of(ridges[1])];
  const Facet& f2 = facets[facet_of(ridges[2])];
  const Facet& f3 = facets[facet_of(ridges[3])];
  const Point3& p0 = facets.point(f0.links.corners[0]);
  const Point3& p1 = facets.point(f1.links.corners[0]);
  const Point3& p2 = facets.point(f2.links.corners[0]);
  const Point3& p3 = facets.point(f3.links.corners[0]);
  const FourWords bits{f0.error.bits(), f1.error.bits(), f2.error.bits(), f3.error.bits()};
  const Four square =
      __builtin_convertvector(reinterpret_cast<FourFloats>(bits & 0xffff0000u), Four);
  const Four linear = __builtin_convertvector(reinterpret_cast<FourFloats>(bits << 16), Four);
  const Four x = q.x - Four{p0.x, p1.x, p2.x, p3.x};
  const Four y = q.y - Four{p0.y, p1.y, p2.y, p3.y};
  const Four z = q.z - Four{p0.z, p1.z, p2.z, p3.z};
  const Four w = square == 0 ? Four{} : x * x + y * y + z * z;
  value = Four{f0.nx, f1.nx, f2.nx, f3.nx} * x + Four{f0.ny, f1.ny, f2.ny, f3.ny} * y +
          Four{f0.nz, f1.nz, f2.nz, f3.nz} * z - w;
  const Four l1_norm = magnitude(x) + magnitude(y) + magnitude(z);
  error = square * w + linear * (l1_norm * facets.reach());
}

TETSCULPT_FOUR_LANES inline Seen see_four(const Facets& facets, const std::array<Ridge, 4>& ridges,
                                          const Point3& q) {
  Four value;
  Four error;
  four_heights(facets, ridges, q, value, error);
  const auto visible = value > error;
  const auto clear = visible | (value < -error);
  return {pattern(visible), pattern(~clear)};
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
  const Four nx = scale * -(yz * c.w - yw * c.z + zw * c.y);
  const Four ny = scale * -(zx * c.w - zw * c.x + xw * c.z);
  const Four nz = scale * -(xy * c.w - xw * c.y + yw * c.x);
  const Four infinite = HUGE_VAL - Four{};
  const Four square =
      good ? ErrorFactors::kRoundings * scale * (a.length * b.length * c.length) : infinite;
  const Four linear = square * ((a.length + b.length + c.length) * facets.per_reach());
  const FourWords high =
      reinterpret_cast<FourWords>(__builtin_convertvector(square, FourFloats)) + 0x10000u;
  const FourWords low =
      reinterpret_cast<FourWords>(__builtin_convertvector(linear, FourFloats)) + 0x10000u;
  const FourWords bits = (high & 0xffff0000u) | low >> 16;
  for (std::size_t i = 0; i < 4; ++i) {
    facets.set_hyperplane(f[i], nx[i], ny[i], nz[i], ErrorFactors::of_bits(bits[i]));
  }
}

}  // namespace

bool has_four_lanes() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

void see_neighbors(const Facets& facets, std::span<const FacetIndex> list, const Point3& q,
                   std::uint32_t known, Seen* seen) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto& neighbors = facets.neighbors(list[k]);
    unsigned visible = 0;
    unsigned unclear = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const FacetIndex g = facet_of(neighbors[i]);
      if (facets[g].mark >= known) continue;
      const Facets::Height h = facets.height(g, q);
      const bool sees = h.value > h.error;
      visible |= unsigned{sees} << i;
      unclear |= unsigned{!sees && !(h.value < -h.error)} << i;
    }
    seen[k] = {static_cast<std::uint8_t>(visible), static_cast<std::uint8_t>(unclear)};
  }
}

TETSCULPT_FOUR_LANES void see_neighbors_by_four(const Facets& facets,
                                                std::span<const FacetIndex> list, const Point3& q,
                                                Seen* seen) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    seen[k] = see_four(facets, facets.neighbors(list[k]), q);
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
  four_heights(facets, facets.neighbors(f), q, value, error);
  NeighborHeights heights;
  std::memcpy(&heights.value, &value, sizeof value);
  heights.visible = pattern(value > error);
  return heights;
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
