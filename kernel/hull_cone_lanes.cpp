#include "kernel/hull_cone_lanes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "kernel/four_lanes.h"
#include "kernel/four_rows.h"

namespace tetsculpt::hull {
namespace {

template <class S>
inline S& spoke_at(S* spokes, SpokePlace place) {
  static_assert(sizeof(Spoke) == 4 * sizeof(double));
  using Double = std::conditional_t<std::is_const_v<S>, const double, double>;
  return *reinterpret_cast<S*>(reinterpret_cast<Double*>(spokes) + place);
}

/// The corner that may be new where a facet is met through a ridge. Takes the facet's mark away.
inline Site corner_met(Facets& facets, Ridge r) {
  facets.mark(facet_of(r)) = Mark::kUnmet;
  return facets.corners(facet_of(r))[corner_of(r)];
}

inline void link(Facets& facets, const ConeFacet& c, const HalfRidges& half_ridges) {
  const auto& to = c.spokes;
  auto& neighbors = facets.neighbors(c.facet);
  neighbors[1] = half_ridges(to[1], to[2]);
  neighbors[2] = half_ridges(to[2], to[0]);
  neighbors[3] = half_ridges(to[0], to[1]);
}

/// To any site in the place of infinity.
TETSCULPT_FOUR_LANES inline void set_four_spokes(std::span<const Point3> points, const Point3& apex,
                                                 const std::array<Site, 4>& sites,
                                                 const SpokePlace* places, SpokePlace* table,
                                                 Spoke* spokes) {
  const auto last = static_cast<Site>(points.size() - 1);
  const auto point = [&](std::size_t i) -> const Point3& {
    spoke_of(table, sites[i]) = places[i];
    return points[std::min(sites[i], last)];
  };
  const Point3& a = point(0);
  const Point3& b = point(1);
  const Point3& c = point(2);
  const Point3& d = point(3);
  Four x;
  Four y;
  load_two<0>(a, b, c, d, x, y);
  x = x - apex.x;
  y = y - apex.y;
  Four z = Four{a.z, b.z, c.z, d.z} - apex.z;
  Four w = x * x + y * y + z * z;
  transpose(x, y, z, w);
  std::memcpy(&spoke_at(spokes, places[0]), &x, sizeof x);
  std::memcpy(&spoke_at(spokes, places[1]), &y, sizeof y);
  std::memcpy(&spoke_at(spokes, places[2]), &z, sizeof z);
  std::memcpy(&spoke_at(spokes, places[3]), &w, sizeof w);
}

/// From the apex to one of the corners of four facets.
template <std::size_t kCorner>
TETSCULPT_FOUR_LANES inline FourRows spokes_to_corner(const ConeFacet* four, const Spoke* spokes) {
  return rows(spoke_at(spokes, four[0].spokes[kCorner]), spoke_at(spokes, four[1].spokes[kCorner]),
              spoke_at(spokes, four[2].spokes[kCorner]), spoke_at(spokes, four[3].spokes[kCorner]));
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

void set_spokes(Facets& facets, std::span<const Point3> points, Site apex,
                std::span<const Ridge> visible, const SpokePlace* places, SpokePlace* table,
                Spoke* spokes) {
  const auto set = [&](Site s) {
    spoke_of(table, s) = *places;
    spoke_at(spokes, *places++) =
        s == kAtInfinity ? facets.spoke_to_infinity() : lifted_difference(points[s], points[apex]);
  };
  for (const Site s : facets.corners(facet_of(visible[0]))) set(s);
  facets.mark(facet_of(visible[0])) = Mark::kUnmet;
  for (const Ridge r : visible.subspan(1)) set(corner_met(facets, r));
}

TETSCULPT_FOUR_LANES void set_spokes_by_four(Facets& facets, std::span<const Point3> points,
                                             Site apex, std::span<const Ridge> visible,
                                             const SpokePlace* places, SpokePlace* table,
                                             Spoke* spokes) {
  const Point3 p = points[apex];
  spoke_of(table, kAtInfinity) = kNone;
  set_four_spokes(points, p, facets.corners(facet_of(visible[0])), places, table, spokes);
  facets.mark(facet_of(visible[0])) = Mark::kUnmet;
  for (std::size_t k = 1; k < visible.size(); k += 4) {
    const Ridge* const four = &visible[k];
    const std::array<Site, 4> sites{corner_met(facets, four[0]), corner_met(facets, four[1]),
                                    corner_met(facets, four[2]), corner_met(facets, four[3])};
    places += 4;
    set_four_spokes(points, p, sites, places, table, spokes);
  }
  const SpokePlace infinity = spoke_of(table, kAtInfinity);
  if (infinity != kNone) spoke_at(spokes, infinity) = facets.spoke_to_infinity();
}

void finish_cone(Facets& facets, Site apex, std::span<const ConeFacet> cone, const Spoke* spokes,
                 const HalfRidges& half_ridges) {
  const LiftedDifference p = facets.lifted(facets.point(apex));
  for (const ConeFacet& c : cone) {
    if (half_ridges.used()) link(facets, c, half_ridges);
    facets.set_hyperplane(c.facet, p, spoke_at(spokes, c.spokes[0]), spoke_at(spokes, c.spokes[1]),
                          spoke_at(spokes, c.spokes[2]));
  }
}

TETSCULPT_FOUR_LANES void finish_cone_by_four(Facets& facets, Site apex,
                                              std::span<const ConeFacet> cone, const Spoke* spokes,
                                              const HalfRidges& half_ridges) {
  const LiftedDifference p = facets.lifted(facets.point(apex));
  for (std::size_t k = 0; k < cone.size(); k += 4) {
    const ConeFacet* const four = &cone[k];
    if (half_ridges.used()) {
      link(facets, four[0], half_ridges);
      link(facets, four[1], half_ridges);
      link(facets, four[2], half_ridges);
      link(facets, four[3], half_ridges);
    }
    set_four(facets, {four[0].facet, four[1].facet, four[2].facet, four[3].facet}, p,
             spokes_to_corner<0>(four, spokes), spokes_to_corner<1>(four, spokes),
             spokes_to_corner<2>(four, spokes));
  }
}

}  // namespace tetsculpt::hull
