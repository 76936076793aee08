#pragma once

#include <functional>

#include "kernel/edge_order.h"
#include "kernel/tet_complex.h"
#include "sculpt/circumspheres.h"
#include "sculpt/evidence.h"
#include "sculpt/sculpture.h"
#include "sculpt/star_faults.h"

/// A surface through all vertices where labels alone give none.
namespace tetsculpt {

/// Labels anew where a first cut had these faults (sculpt/labels.h), and makes a 2-manifold through
/// all vertices of it. Vertices that stay hidden, in practice none, are listed. `alone` flags
/// tetrahedra that are labelled singly, as in sculpt/label_graph.h. `progress` is told now and
/// then, from 0 to 1, and may throw.
Sculpture mended_surface(const TetComplex& complex, const Circumspheres& spheres,
                         const Evidence& evidence, const StarFaults& faults, Flags alone,
                         const std::function<void(double)>& progress);

}  // namespace tetsculpt
