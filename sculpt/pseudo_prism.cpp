#include "sculpt/pseudo_prism.h"

#include <optional>

#include "sculpt/exposure.h"

namespace tetsculpt {
namespace {

/// A chain's six vertices a, b, c, d, e, f, with the names of the header.
using Chain = std::array<VertexId, 6>;

/// The corner by which `t` touches `u`: the one of t opposite their common facet. -1 if they have
/// none.
int corner_towards(const ManifoldSolid& solid, TetId t, TetId u) {
  for (int i = 0; i < 4; ++i) {
    if (solid.neighbor(t, i) == u) return i;
  }
  return -1;
}

VertexId vertex(const ManifoldSolid& solid, TetId t, int corner) {
  return solid.vertices(t)[static_cast<std::size_t>(corner)];
}

bool on_boundary(const ManifoldSolid& solid, TetId t, int facet) {
  return (solid.faces(t) >> facet & 1) != 0;
}

/// Names the chain's vertices. The middle tetrahedron shares two corners with both ends: c and d,
/// told apart by which facets are then the bases; nothing if no choice puts both bases on the
/// boundary.
std::optional<Chain> chain_of(const ManifoldSolid& solid, const PseudoPrism& prism) {
  const auto [first, middle, last] = prism.tets;
  const int a = corner_towards(solid, first, middle);
  const int f = corner_towards(solid, last, middle);
  const int e = corner_towards(solid, middle, first);
  const int b = corner_towards(solid, middle, last);
  if (a < 0 || f < 0 || e < 0 || b < 0) return std::nullopt;
  const int edge_eb = kEdgeOfCorners[static_cast<std::size_t>(e)][static_cast<std::size_t>(b)];
  const auto& cd = kEdgeCorners[static_cast<std::size_t>(5 - edge_eb)];
  // d is the one of the two whose opposite facet in the first tetrahedron, abc, is a base.
  for (const std::size_t swap : {0u, 1u}) {
    const VertexId c = vertex(solid, middle, cd[swap]);
    const VertexId d = vertex(solid, middle, cd[1 - swap]);
    if (!on_boundary(solid, first, corner_of(solid.vertices(first), d)) ||
        !on_boundary(solid, last, corner_of(solid.vertices(last), c))) {
      continue;
    }
    return Chain{vertex(solid, first, a),  vertex(solid, middle, b), c, d,
                 vertex(solid, middle, e), vertex(solid, last, f)};
  }
  return std::nullopt;
}

/// The edge of a tetrahedron between two of its vertices.
struct EdgeOfTet {
  TetId tet;
  int edge;
};
EdgeOfTet edge_between(const ManifoldSolid& solid, TetId t, VertexId p, VertexId q) {
  const auto& v = solid.vertices(t);
  return {t, kEdgeOfCorners[static_cast<std::size_t>(corner_of(v, p))]
                           [static_cast<std::size_t>(corner_of(v, q))]};
}

}  // namespace

bool is_pseudo_prism(const ManifoldSolid& solid, const PseudoPrism& prism) {
  const auto [first, middle, last] = prism.tets;
  for (const TetId t : prism.tets) {
    if (!solid.solid(t)) return false;
  }
  // Only the bases are on the boundary: no other facet of the three, the coastal triangles
  // included.
  if (solid.faces(middle) != 0 || facet_count(solid.faces(first)) != 1 ||
      facet_count(solid.faces(last)) != 1) {
    return false;
  }
  const std::optional<Chain> chain = chain_of(solid, prism);
  if (!chain) return false;
  const auto [a, b, c, d, e, f] = *chain;
  if (a == e || a == f || b == f) return false;
  const std::array<EdgeOfTet, 6> coastal{
      edge_between(solid, first, a, d),  edge_between(solid, middle, b, d),
      edge_between(solid, middle, c, d), edge_between(solid, middle, b, e),
      edge_between(solid, middle, c, e), edge_between(solid, last, c, f)};
  bool in_emst = false;
  for (const auto& [tet, edge] : coastal) {
    if (solid.edge_on_boundary(tet, edge)) return false;
    in_emst = in_emst || solid.in_emst(tet, edge);
  }
  return in_emst;
}

std::vector<PseudoPrism> pseudo_prisms(const ManifoldSolid& solid, TetId t, int corner) {
  std::vector<PseudoPrism> prisms;
  // What is_pseudo_prism asks of the first two, before the last one comes from far away.
  if (facet_count(solid.faces(t)) != 1) return prisms;
  for (int a = 0; a < 4; ++a) {
    if (a == corner) continue;
    // Leave the first tetrahedron through the facet opposite a, which is a corner of the base.
    const Facet middle = solid.across(t, a);
    if (!solid.solid(middle.tet) || solid.faces(middle.tet) != 0) continue;
    for (int b = 0; b < 4; ++b) {
      if (b == middle.corner) continue;
      const TetId last = solid.neighbor(middle.tet, b);
      if (last == t || !solid.solid(last)) continue;
      const PseudoPrism prism{{t, middle.tet, last}};
      if (is_pseudo_prism(solid, prism)) prisms.push_back(prism);
    }
  }
  return prisms;
}

}  // namespace tetsculpt
