#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/edge_order.h"
#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/tet_complex.h"
#include "sculpt/poles.h"

/// Sets of tetrahedra that get one label, and the facets between them.
namespace tetsculpt {

/// Nodes are connected sets of tetrahedra; node kOutside holds all the infinite ones. Arcs come in
/// pairs, one per facet between two nodes and direction.
struct LabelGraph {
  using Node = std::uint32_t;
  static constexpr Node kOutside = 0;
  struct Arc {
    Node head;
    std::uint32_t mate;  ///< the same facet from its other side
    TriangleId triangle;
    float overlap;  ///< of the triangle, here once more: it is read wherever arcs are followed
  };

  LargeArray<Node> node_of_tet;
  LargeArray<std::uint32_t> tets_in;  ///< per node
  LargeArray<std::uint32_t> first;    ///< per node its first arc, and one more; arcs are in order
  LargeArray<Arc> arcs;

  std::size_t node_count() const { return tets_in.size(); }
  std::span<const Arc> arcs_of(Node x) const {
    return std::span(arcs).subspan(first[x], first[x + 1] - first[x]);
  }
};

/// Joins tetrahedra across all facets whose circumspheres overlap so deeply that no surface runs
/// there; tetrahedra flagged in `alone`, which may be empty, stay alone. `overlap` has a cosine per
/// triangle, see sculpt/circumspheres.h. Nodes are numbered by their first tetrahedra. Cost: near
/// linear.
LabelGraph label_graph(const TetComplex& complex, std::span<const float> overlap,
                       const Flags& alone);

/// Flags the tetrahedra at the vertices whose two poles got into one node, as happens where
/// sampling is coarse or uneven: they had better stay alone. No flag at all where this concerns
/// less than one vertex in a thousand.
Flags contradicted_tets(const TetComplex& complex, const LabelGraph& graph,
                        std::span<const PolePair> pairs);

}  // namespace tetsculpt
