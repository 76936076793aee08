#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/distinct_points.h"
#include "kernel/hull_facets.h"
#include "kernel/hull_region.h"
#include "kernel/lifted_hull.h"

/// Hulls to grow a region in, and what it should be.
namespace tetsculpt::hull_regions {

using hull::FacetIndex;
using hull::Facets;
using hull::Ridge;
using hull::Site;

/// The hull of all sites but the last ones, with infinity as the last corner of a facet.
struct Hull : Facets {
  explicit Hull(std::span<const Point3> sites, std::size_t left_out = 1)
      : Facets(sites, std::ldexp(1.0, *unit_exponent(sites, 10'000))) {
    const LiftedHull hull = lifted_hull(sites.first(sites.size() - left_out));
    hull::FacetRoom room = append(hull.tets.size());
    room.begin = static_cast<FacetIndex>(hull.tets.size());
    give_back({room});
    // An even number of exchanges keeps the orientation.
    const auto turned = [&](std::size_t t) { return hull.tets[t][2] == kInfinite; };
    const auto corner = [&](std::size_t t, std::uint32_t i) { return turned(t) ? i ^ 1 : i; };
    for (FacetIndex t = 0; t < hull.tets.size(); ++t) {
      for (std::uint32_t i = 0; i < 4; ++i) {
        const VertexId v = hull.tets[t][i];
        const FacetHandle h = hull.neighbors[t][i];
        corners(t)[corner(t, i)] = v == kInfinite ? hull::kAtInfinity : static_cast<Site>(+v);
        neighbors(t)[corner(t, i)] = hull::ridge(h / 4, corner(h / 4, h % 4));
      }
      set_hyperplane(t);
    }
  }
};

/// What a region should be, in ascending order.
struct Expected {
  std::vector<FacetIndex> visible;
  std::vector<Ridge> cut;

  Expected(const Facets& facets, std::size_t facet_count, Site apex) {
    for (FacetIndex f = 0; f < facet_count; ++f) {
      if (!facets.visible(f, apex)) continue;
      visible.push_back(f);
      for (std::uint32_t i = 0; i < 4; ++i) {
        const FacetIndex g = hull::facet_of(facets.neighbors(f)[i]);
        if (!facets.visible(g, apex)) cut.push_back(hull::ridge(f, i));
      }
    }
  }
};

inline std::vector<std::uint32_t> sorted(const hull::Stack<Ridge>& list) {
  std::vector<std::uint32_t> result(list.begin(), list.end());
  std::ranges::sort(result);
  return result;
}

inline std::size_t marked(Facets& facets, std::size_t facet_count) {
  std::size_t count = 0;
  for (FacetIndex f = 0; f < facet_count; ++f) count += facets.mark(f) != hull::Mark::kUnmet;
  return count;
}

}  // namespace tetsculpt::hull_regions
