#pragma once

#include <cstddef>
#include <functional>

#include "kernel/hull_facets.h"
#include "kernel/lifted_hull.h"

/// From the store of the growing hull to the result. Internal to kernel/lifted_hull.
namespace tetsculpt::hull {

/// The facets that live, which leave the store, as tetrahedra in canonical order: finite ones
/// first, then by their corners in ascending order. Neighbours in space are then neighbours in
/// memory, and it does not matter how the hull was made. `progress` is told a share from 0 to 1
/// after each pass. `by_four` only where has_four_lanes(). Cost: four passes over the facets,
/// shared by the threads.
LiftedHull output(Facets& facets, std::size_t site_count, int threads, bool by_four,
                  const std::function<void(double)>& progress);

}  // namespace tetsculpt::hull
