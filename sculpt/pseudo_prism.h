#pragma once

#include <array>
#include <vector>

#include "kernel/ids.h"
#include "sculpt/manifold_solid.h"

/// The paper's pseudo-prisms: what is removed to open a hole (section 3.2, Figures 4 and 5).
namespace tetsculpt {

///   a-----c          A chain of three face-adjacent solid tetrahedra over six distinct vertices:
///   |\   /|          (a, b, c, d), (b, c, d, e), (c, d, e, f). Its bases abc and def are on the
///   | \ / |          boundary; none of its six coastal edges ad, bd, cd, be, ce, cf and none of
///   its |  b  |          six coastal triangles is. Removing it joins the bases: one more handle.
///   d--|--f
///    \ | /
///      e
struct PseudoPrism {
  std::array<TetId, 3> tets;
};

/// The pseudo-prisms one of whose bases is facet `corner` of t, with a coastal edge in the EMST.
/// Precondition: t is solid and that facet is on the boundary. At most six.
std::vector<PseudoPrism> pseudo_prisms(const ManifoldSolid& solid, TetId t, int corner);

/// True if the chain still is a pseudo-prism as described above.
bool is_pseudo_prism(const ManifoldSolid& solid, const PseudoPrism& prism);

}  // namespace tetsculpt
