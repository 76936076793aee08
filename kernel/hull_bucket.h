#pragma once

#include <cstdint>
#include <span>

#include "kernel/hull_facets.h"
#include "kernel/lifted_hull.h"

/// Tetrahedra with one lowest corner, put in order. Internal to kernel/hull_output.
namespace tetsculpt::hull {

/// Writes the tetrahedra [begin, end) of a hull, in their order: the facets that are listed at
/// [begin, end). Their neighbours stay what they are to the facets. Facet of the tetrahedron (4 *
/// tetrahedron + corner) takes the place of each of the facet's own corners.
void write_bucket(FacetLinks* facets, std::span<const FacetIndex> list, std::uint32_t begin,
                  std::uint32_t end, LiftedHull& hull);
/// The same four corners at a time, where has_four_lanes().
void write_bucket_by_four(FacetLinks* facets, std::span<const FacetIndex> list, std::uint32_t begin,
                          std::uint32_t end, LiftedHull& hull);

}  // namespace tetsculpt::hull
