#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/disjoint_sets.h"
#include "kernel/ids.h"
#include "kernel/lifted_hull.h"

/// The pass over tetrahedra in which triangles and edges get their ids. Internal to
/// kernel/simplices.
namespace tetsculpt::simplices {

inline constexpr EdgeId kNoEdge{0xffffffffu};
inline constexpr TriangleId kNoTriangle{0xffffffffu};

/// Corners ascend but for the last two, which may descend: then the tetrahedron is odd.
inline bool is_odd(const std::array<VertexId, 4>& tet) { return tet[2] > tet[3]; }

/// The rank in ascending order of a corner, or the corner of a rank.
constexpr std::size_t rank(std::size_t corner, std::uint8_t odd) {
  return corner ^ (odd & corner >> 1);
}

/// The edges of a tetrahedron, by the ranks of their ends.
using RankedEdges = std::array<EdgeId, 6>;

/// The edges of the facet opposite each rank. Two neighbours have these in the same order.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> kFacetEdges{
    {{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}}};

/// Those of a facet, given of each tetrahedron whether it is odd.
inline const std::array<std::uint8_t, 3>& edges_of_facet(FacetHandle f, const std::uint8_t* odd) {
  return kFacetEdges[rank(f & 3, odd[f >> 2])];
}

/// So many ids behind those of a stretch belong to nobody: they may be written to.
inline constexpr std::uint32_t kBetweenStretches = 8;

/// Tetrahedra that are swept in their order, by one thread.
struct Stretch {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t next_triangle = 0;  ///< the next id
  std::uint32_t triangles_end = 0;
  std::uint32_t next_edge = 0;
  std::vector<FacetHandle> joints;  ///< facets whose other side comes before the stretch
};

/// What a sweep reads and writes: of other stretches nothing.
struct Sweep {
  const std::array<FacetHandle, 4>* neighbors;
  const std::uint8_t* odd;
  std::array<TriangleId, 4>* triangles_of;
  RankedEdges* edges_of;
  FacetHandle* facet_of;   ///< per triangle
  std::uint32_t* made_in;  ///< per id of an edge, 6 * tetrahedron + the edge there, by ranks
  DisjointSets& same;      ///< of ids, one set per edge
};

/// Takes ids of triangles and edges over from neighbours in the stretch that were swept before, and
/// makes new ones for what none of them has. Those before `from` were swept.
void sweep(const Sweep& all, Stretch& stretch, std::uint32_t from, std::uint32_t to);
/// The same, where hull::has_four_lanes(), with fewer branches that nobody can guess: all triangles
/// and edges come in 0.8 to 0.9 of the time.
void sweep_by_eight(const Sweep& all, Stretch& stretch, std::uint32_t from, std::uint32_t to);

}  // namespace tetsculpt::simplices
