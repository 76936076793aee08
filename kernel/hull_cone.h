#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernel/hull_cone_lanes.h"
#include "kernel/hull_facets.h"
#include "kernel/hull_region.h"
#include "kernel/large_array.h"
#include "kernel/point.h"

/// New facets around a point that takes the place of what it sees. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// Puts up cones, one after the other.
class Cone {
 public:
  Cone(std::span<const Point3> points, Facets& facets, bool by_four);
  /// Over the region's horizon, one facet per ridge that is cut, with the apex as first corner, in
  /// the place of facets that are free. The region's facets lose their marks.
  void put_up(Site apex, Region& region, std::span<const Ridge> free);
  /// In the order of the ridges that are cut.
  std::span<const ConeFacet> facets() const { return cone_.held(); }

 private:
  const SpokePlace* places_for(std::size_t count);
  void set_spokes(Site apex, Region& region);
  template <bool kInTable>
  void put_up_facets(Site apex, const Region& region, const Ridge* free);
  void link_by_sorting();

  std::span<const Point3> points_;
  Facets& facets_;
  bool by_four_;
  Stack<ConeFacet> cone_;
  Stack<Spoke> spokes_;               ///< from the apex to corners of the cavity
  std::vector<SpokePlace> in_a_row_;  ///< places for many
  HalfRidges half_ridges_;            ///< not used where there are many
  Stack<Ridge> half_ridge_room_;
  LargeArray<SpokePlace> spoke_of_;  ///< in the last cavity that had the site for a corner
};

}  // namespace tetsculpt::hull
