#pragma once

#include <cstdint>
#include <span>

#include "kernel/edge_order.h"
#include "kernel/large_array.h"
#include "kernel/tet_complex.h"
#include "sculpt/circumspheres.h"
#include "sculpt/first_guess.h"
#include "sculpt/label_graph.h"
#include "sculpt/poles.h"

/// What positions alone say about which tetrahedra lie inside: the energy that labels minimise.
namespace tetsculpt {

struct Evidence {
  /// Per finite tetrahedron: how much more it costs to call it outside than inside.
  LargeArray<float> inside_bias;
  /// Per triangle: how deeply the spheres on its two sides overlap, and is it in the EGH?
  LargeArray<float> overlap;
  std::span<const std::uint8_t> egh_triangles;
  /// What it costs to have the surface at a triangle. Positive.
  float facet_cost(TriangleId t) const { return facet_cost(t, overlap[+t]); }
  /// The same for who has its overlap at hand.
  float facet_cost(TriangleId t, float its_overlap) const;
  /// Per vertex: which pole is believed inside, and which outside. Equal where nothing is known.
  struct Poles {
    TetId inside{};
    TetId outside{};
  };
  LargeArray<Poles> believed;
};

/// Weighs poles, normals, overlaps of circumspheres and the EGH, with `guess` as to which pole is
/// which. The source gives the weights and where they come from. Keeps a reference to
/// `egh_triangles`.  Cost: linear.
Evidence weigh_evidence(std::span<const Point3> points, const TetComplex& complex,
                        const Circumspheres& spheres, std::span<const PolePair> pairs,
                        const LabelGraph& graph, std::span<const Side> guess,
                        LargeArray<float> overlap, const Flags& egh_triangles);

}  // namespace tetsculpt
