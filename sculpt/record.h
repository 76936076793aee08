#pragma once

#include <cstdint>
#include <vector>

#include "kernel/ids.h"
#include "kernel/sculpting_record.h"
#include "kernel/tet_complex.h"
#include "sculpt/sculpture.h"

/// The record of a sculpting, for those who want to watch it.
namespace tetsculpt {

/// Tetrahedra that change sides, one after another, from the start in which all finite ones are
/// inside. One may do so several times.
struct SculptingSteps {
  std::vector<TetId> tets;
  /// Per entry of `tets`, the step in which it changes: from 1, never falling.
  std::vector<std::uint32_t> step;
};

/// How a sculpture came about.
///   Where it was made by removal: the removals, those of a pseudo-prism in one step.
///   Else from its labels: first the tetrahedra that the labels put outside, layer by layer from
///   the convex hull inwards, voids last; then those that were moved to the other side, the ones
///   next to the surface of the labels first. What was moved there and back is left out.
/// Cost: linear.
SculptingSteps sculpting_steps(const TetComplex& complex, const Sculpture& sculpture);

/// The triangles of the surface at each step, corners as values of vertex ids. The ones that are
/// there at the end come last, in the order of boundary_triangles (sculpt/boundary.h).
/// Cost: linear; 4 bytes per triangle of the complex.
SculptingRecord sculpting_record(const TetComplex& complex, const SculptingSteps& steps);

}  // namespace tetsculpt
