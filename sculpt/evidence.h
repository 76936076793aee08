#pragma once

#include <span>
#include <vector>

#include "kernel/edge_order.h"
#include "kernel/tet_complex.h"
#include "kernel/vertex_stars.h"
#include "sculpt/circumspheres.h"
#include "sculpt/poles.h"

/// What positions alone say about which tetrahedra lie inside: the energy that labels minimise.
namespace tetsculpt {

struct Evidence {
  /// Per finite tetrahedron: how much more it costs to call it outside than inside.
  std::vector<double> inside_bias;
  /// Per triangle: what it costs to have the surface there. Positive.
  std::vector<double> facet_cost;
  /// Per vertex: which pole is believed inside, and which outside. Equal where nothing is known.
  struct Poles {
    TetId inside{};
    TetId outside{};
  };
  std::vector<Poles> believed;
};

/// Weighs poles, normals, overlaps of circumspheres and the EGH. The source gives the weights and
/// where they come from.  Cost: a heap of the tetrahedra, otherwise linear.
Evidence weigh_evidence(std::span<const Point3> points, const TetComplex& complex,
                        const VertexStars& stars, const Circumspheres& spheres,
                        const Flags& egh_triangles);

}  // namespace tetsculpt
