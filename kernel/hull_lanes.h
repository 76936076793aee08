#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "kernel/four_lanes.h"
#include "kernel/hull_facets.h"
#include "kernel/hull_region.h"
#include "kernel/point.h"

/// What an insertion looks for among facets: four at a time where has_four_lanes(), one after the
/// other elsewhere. Both are exact where they decide, so it makes no difference to the hull.
/// Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// Looks around the visible facets of a region from `begin` on, and those that they add: the
/// neighbours that a point, lifted from the middle, sees clearly become visible, unclear ones are
/// listed, both once; ridges to those that are clearly hidden are cut. Marks what is visible or
/// unclear. False, and an unfinished region, at a facet that is not within the range: the first one
/// must be, of others the corner behind the ridge through which they were met decides. By centers,
/// all neighbours must be, too, and nothing that is not is marked.
bool expand(Facets& facets, const LiftedDifference& point, const Range& own, std::size_t begin,
            Region& region);
/// A facet is tested once from each visible neighbour, which takes less than to keep track.
bool expand_by_four(Facets& facets, const LiftedDifference& point, const Range& own,
                    std::size_t begin, Region& region);

/// Where a walk went, and whether q clearly sees that facet.
struct Nearer {
  FacetIndex facet;
  bool seen;
};
/// From f, which is finite and in the range, to neighbours above which q is higher, each time to
/// the highest of four, where has_four_lanes(): to a facet that q sees, be it the first beyond the
/// range, or to a finite one where the next would not be higher, or infinite, or not within the
/// range.
Nearer nearer_by_four(const Facets& facets, FacetIndex f, const LiftedDifference& q,
                      const Range& own);

}  // namespace tetsculpt::hull
