#include "sculpt/pseudo_prism.h"

#include <optional>

namespace tetsculpt {
namespace {

/// A chain's six vertices a, b, c, d, e, f, with the names of the header.
using Chain = std::array<VertexId, 6>;

/// The corner by which `t` touches `u`: the one of t opposite their common facet. -1 if they have
/// none.
int corner_towards(const TetComplex& complex, TetId t, TetId u) {
  for (int i = 0; i < 4; ++i) {
    if (complex.neighbor(t, i) == u) return i;
  }
  return -1;
}

VertexId vertex(const TetComplex& complex, TetId t, int corner) {
  return complex.vertices(t)[static_cast<std::size_t>(corner)];
}

/// Names the chain's vertices. The middle tetrahedron shares two corners with both ends: c and d,
/// told apart by which facets are then the bases; nothing if no choice puts both bases on the
/// boundary.
std::optional<Chain> chain_of(const Boundary& boundary, const PseudoPrism& prism) {
  const TetComplex& complex = boundary.complex();
  const auto [first, middle, last] = prism.tets;
  const int a = corner_towards(complex, first, middle);
  const int f = corner_towards(complex, last, middle);
  const int e = corner_towards(complex, middle, first);
  const int b = corner_towards(complex, middle, last);
  if (a < 0 || f < 0 || e < 0 || b < 0) return std::nullopt;
  const int edge_eb = kEdgeOfCorners[static_cast<std::size_t>(e)][static_cast<std::size_t>(b)];
  const auto& cd = kEdgeCorners[static_cast<std::size_t>(5 - edge_eb)];
  // d is the one of the two whose opposite facet in the first tetrahedron, abc, is a base.
  for (const std::size_t swap : {0u, 1u}) {
    const VertexId c = vertex(complex, middle, cd[swap]);
    const VertexId d = vertex(complex, middle, cd[1 - swap]);
    const Facet abc{first, corner_of(complex.vertices(first), d)};
    const Facet def{last, corner_of(complex.vertices(last), c)};
    if (!boundary.on_boundary(abc) || !boundary.on_boundary(def)) {
      continue;
    }
    return Chain{vertex(complex, first, a),  vertex(complex, middle, b), c, d,
                 vertex(complex, middle, e), vertex(complex, last, f)};
  }
  return std::nullopt;
}

EdgeId edge_between(const TetComplex& complex, TetId t, VertexId p, VertexId q) {
  const auto& v = complex.vertices(t);
  return complex.edge(t, kEdgeOfCorners[static_cast<std::size_t>(corner_of(v, p))]
                                       [static_cast<std::size_t>(corner_of(v, q))]);
}

}  // namespace

bool is_pseudo_prism(const Boundary& boundary, const PseudoPrism& prism,
                     const Flags& flagged_edges) {
  const TetComplex& complex = boundary.complex();
  const auto [first, middle, last] = prism.tets;
  for (const TetId t : prism.tets) {
    if (!boundary.solid(t)) return false;
  }
  // Only the bases are on the boundary: no other facet of the three, the coastal triangles
  // included.
  if (boundary.faces(middle) != 0 || facet_count(boundary.faces(first)) != 1 ||
      facet_count(boundary.faces(last)) != 1) {
    return false;
  }
  const std::optional<Chain> chain = chain_of(boundary, prism);
  if (!chain) return false;
  const auto [a, b, c, d, e, f] = *chain;
  if (a == e || a == f || b == f) return false;
  const std::array<EdgeId, 6> coastal{
      edge_between(complex, first, a, d),  edge_between(complex, middle, b, d),
      edge_between(complex, middle, c, d), edge_between(complex, middle, b, e),
      edge_between(complex, middle, c, e), edge_between(complex, last, c, f)};
  bool flagged = false;
  for (const EdgeId edge : coastal) {
    if (boundary.on_boundary(edge)) return false;
    flagged = flagged || flagged_edges[+edge];
  }
  return flagged;
}

std::vector<PseudoPrism> pseudo_prisms(const Boundary& boundary, TetId t, int corner,
                                       const Flags& flagged_edges) {
  const TetComplex& complex = boundary.complex();
  std::vector<PseudoPrism> prisms;
  for (int a = 0; a < 4; ++a) {
    if (a == corner) continue;
    // Leave the first tetrahedron through the facet opposite a, which is a corner of the base.
    const Facet middle = complex.across(t, a);
    if (!boundary.solid(middle.tet)) continue;
    for (int b = 0; b < 4; ++b) {
      if (b == middle.corner) continue;
      const TetId last = complex.neighbor(middle.tet, b);
      if (last == t || !boundary.solid(last)) continue;
      const PseudoPrism prism{{t, middle.tet, last}};
      if (is_pseudo_prism(boundary, prism, flagged_edges)) prisms.push_back(prism);
    }
  }
  return prisms;
}

}  // namespace tetsculpt
