#pragma once

#include <cstddef>
#include <cstdint>
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
  void place_spokes(std::size_t count);
  void set_spokes(Site apex, Region& region);
  template <bool kInTable>
  void put_up_facets(Site apex, const Region& region, const Ridge* free);
  void link_by_sorting();
  SpokePlace& spoke_of(Site s) { return spoke_of_.data()[static_cast<std::int32_t>(s) + 1]; }

  std::span<const Point3> points_;
  Facets& facets_;
  bool by_four_;
  Stack<ConeFacet> cone_;
  Stack<Spoke> spokes_;                 ///< from the apex to corners of the cavity
  const SpokePlace* places_ = nullptr;  ///< per number of a spoke
  std::vector<SpokePlace> in_a_row_;    ///< places for many
  bool in_table_ = true;                ///< or too many
  HalfRidges half_ridges_;
  Stack<Ridge> half_ridge_room_;
  /// Per site, after the one at infinity: its spoke in the last cavity that had it for a corner.
  LargeArray<SpokePlace> spoke_of_;
};

}  // namespace tetsculpt::hull
