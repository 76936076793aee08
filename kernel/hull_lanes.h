#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "kernel/four_lanes.h"
#include "kernel/hull_facets.h"
#include "kernel/hull_region.h"
#include "kernel/point.h"

/// What an insertion computes for many facets: four at a time where has_four_lanes(), one after the
/// other elsewhere. Both are exact where they decide, so it makes no difference to the
/// hull. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// Looks around the visible facets of a region from `begin` on, and those that they add: the
/// neighbours that a point, lifted from the middle, sees clearly become visible, unclear ones are
/// listed, both once; ridges to those that are clearly hidden are cut. Marks what is visible or
/// unclear. False, and an unfinished region, at a facet that is not within the range.
bool expand(Facets& facets, const LiftedDifference& point, const SiteRange& own, std::size_t begin,
            Region& region);
/// A facet is tested once from each visible neighbour, which takes less than to keep track.
bool expand_by_four(Facets& facets, const LiftedDifference& point, const SiteRange& own,
                    std::size_t begin, Region& region);

/// Facets::height of a point above a facet's four neighbours.
struct NeighborHeights {
  std::array<double, 4> value;
  unsigned visible;  ///< those that are clearly seen, a bit each
};
NeighborHeights neighbor_heights(const Facets& facets, FacetIndex f, const LiftedDifference& q);
NeighborHeights neighbor_heights_by_four(const Facets& facets, FacetIndex f,
                                         const LiftedDifference& q);

/// A new facet through an apex, its first corner, and a ridge of the horizon.
struct ConeFacet {
  FacetIndex facet;
  std::array<std::uint32_t, 3> numbers;  ///< of its corners 1 to 3 among the spokes
};

/// From an apex to corners, whose number is a multiple of four.
void set_spokes(std::span<const Point3> points, Site apex, std::span<const Site> corners,
                Spoke* spokes);
void set_spokes_by_four(std::span<const Point3> points, Site apex, std::span<const Site> corners,
                        Spoke* spokes);

/// Sets the hyperplanes of a cone's facets. The spokes lead from the apex to the other corners. By
/// four, the cone's end is followed by facets of it up to a multiple of four.
void set_hyperplanes(Facets& facets, Site apex, std::span<const ConeFacet> cone,
                     std::span<const Spoke> spokes);
void set_hyperplanes_by_four(Facets& facets, Site apex, std::span<const ConeFacet> cone,
                             std::span<const Spoke> spokes);

}  // namespace tetsculpt::hull
