#pragma once

#include <functional>
#include <span>

#include "kernel/edge_order.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"
#include "sculpt/sculpture.h"

/// Sculpting guided by a belief, for each tetrahedron, on whether it lies inside: the default
/// method.
namespace tetsculpt {

struct GuidedOptions {
  /// Told now and then which share of the work is done, from 0 to 1. May throw: that cancels, and
  /// the exception passes through.
  std::function<void(double)> progress = {};
  /// What to give beyond the solid: Sculpture::labels costs a copy of it.
  enum class Keep { kSolid, kLabels } keep = Keep::kSolid;
};

/// Labels tetrahedra by the evidence of Voronoi poles, overlapping circumspheres and EGH triangles,
/// makes the boundary of the labels a 2-manifold, and deforms it until every vertex is on it.
///   (1) The boundary is a closed 2-manifold whatever the labels say.
///   (2) Vertices that stay hidden are listed.
/// `Sculpture::removed` and `holes` stay empty: labels are not found by removal.
Sculpture sculpt_guided(std::span<const Point3> points, const TetComplex& complex,
                        const Flags& egh_triangles, const GuidedOptions& options = {});

}  // namespace tetsculpt
