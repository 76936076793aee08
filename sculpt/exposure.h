#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "kernel/tet_complex.h"

/// The paper's basic rules (section 3.2).
namespace tetsculpt {

/// How a tetrahedron meets the boundary of a solid, and whether the basic rules allow its removal.
struct Exposure {
  int faces = 0;  ///< boundary faces
  bool removable =
      false;  ///< one face and the opposite vertex hidden, or two and the opposite edge
  std::uint8_t facets = 0;  ///< on the boundary, as Boundary::faces
  int opposite_edge =
      -1;  ///< with two faces: the tetrahedron's edge that joins the other two facets

  bool on_boundary(std::size_t facet) const { return (facets >> facet & 1) != 0; }
};

/// How many facets of a tetrahedron four bits stand for. (std::popcount is a call where processors
/// without an instruction for it must do.)
constexpr int facet_count(unsigned bits) {
  return static_cast<int>(0x4332322132212110ull >> (4 * bits) & 7);
}

/// With two facets, a bit each: the edge opposite to their common one. Facets i and j are opposite
/// corners i and j: their common edge joins the other two corners, this one joins i and j.
constexpr int opposite_edge(unsigned facets) {
  return kEdgeOfCorners[static_cast<std::size_t>(std::countr_zero(facets))]
                       [static_cast<std::size_t>(std::countr_zero(facets & (facets - 1)))];
}

/// Classifies a tetrahedron of a solid (Boundary or ManifoldSolid) by the basic rules, which keep
/// the boundary a 2-manifold of the same topology: never with three or four boundary faces. The
/// rules are the same for taking a solid tetrahedron off and for adding one that is not.
template <class Solid>
Exposure exposure(const Solid& solid, TetId t) {
  const unsigned faces = solid.faces(t);
  Exposure e{.faces = facet_count(faces), .facets = static_cast<std::uint8_t>(faces)};
  if (e.faces == 1) {
    e.removable = !solid.corner_on_boundary(t, std::countr_zero(faces));
  } else if (e.faces == 2) {
    e.opposite_edge = opposite_edge(faces);
    e.removable = !solid.edge_on_boundary(t, e.opposite_edge);
  }
  return e;
}

}  // namespace tetsculpt
