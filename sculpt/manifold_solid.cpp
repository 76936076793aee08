// What a removal changes, by the number of boundary faces. One: its corner opposite and the three
// edges there come out. Two: the edge opposite to their common one comes out, and the common one
// goes. Nothing else leaves the boundary, and the facets that were inside are on it. In a
// pseudo-prism the first tetrahedron goes by one face, its opposite corner being out already, so
// does the second, and the third by two, but their common edge stays: it is one of the base def.
#include "sculpt/manifold_solid.h"

#include <algorithm>
#include <bit>

#include "sculpt/boundary.h"
#include "sculpt/exposure.h"

namespace tetsculpt {
namespace {

/// The edges of each set of facets; the first one again where they are less than six: no branch
/// depends on how many they are. For no facets, any.
constexpr std::array<std::array<std::uint8_t, 6>, 16> kEdgesOfFacets = [] {
  std::array<std::array<std::uint8_t, 6>, 16> table{};
  for (unsigned facets = 1; facets < 16; ++facets) {
    std::size_t count = 0;
    for (std::uint8_t k = 0; k < 6; ++k) {
      if ((kEdgesInside[facets] >> k & 1) == 0) table[facets][count++] = k;
    }
    for (; count < 6; ++count) table[facets][count] = table[facets][0];
  }
  return table;
}();

}  // namespace

ManifoldSolid::ManifoldSolid(std::span<const Point3> points, const TetComplex& complex,
                             const Constraints& constraints)
    : complex_(&complex),
      tets_(complex.finite_tet_count()),
      edge_on_boundary_(complex.edge_count(), false),
      vertex_on_boundary_(complex.vertex_count(), false),
      hidden_(complex.vertex_count()) {
  copy_tets(edges_by_length(points, complex, Flags(complex.edge_count(), 1)), constraints);
}

/// Puts the facets of a tetrahedron that have nothing outside on the boundary.
void ManifoldSolid::show_faces(const Tet& tet) {
  for (unsigned left = tet.faces; left != 0; left &= left - 1) {
    for (const std::size_t corner : kFacetCorners[index(std::countr_zero(left))]) {
      show(tet.vertices[corner]);
    }
  }
  for (unsigned left = 63u & ~kEdgesInside[tet.faces]; left != 0; left &= left - 1) {
    edge_on_boundary_[tet.ranks[index(std::countr_zero(left))]] = true;
  }
}

void ManifoldSolid::copy_tets(std::span<const EdgeId> by_length, const Constraints& constraints) {
  LargeArray<std::uint32_t> rank(by_length.size());
  for (std::uint32_t r = 0; r < by_length.size(); ++r) rank[+by_length[r]] = r;
  const auto& [egh, emst] = constraints;
  for (std::uint32_t i = 0; i < tets_.size(); ++i) {
    const TetId t{i};
    Tet& tet = tets_[i];
    tet.vertices = complex_->vertices(t);
    tet.note = 0;
    tet.solid = true;
    unsigned faces = 0, egh_facets = 0, emst_edges = 0;
    for (int corner = 0; corner < 4; ++corner) {
      const Facet other = complex_->across(t, corner);
      tet.across[index(corner)] = static_cast<FacetHandle>(4 * +other.tet + index(other.corner));
      faces |= unsigned{!complex_->finite(other.tet)} << corner;
      if (!egh.empty()) egh_facets |= unsigned{egh[+complex_->triangle(t, corner)] != 0} << corner;
    }
    for (int k = 0; k < 6; ++k) {
      const EdgeId e = complex_->edge(t, k);
      tet.ranks[index(k)] = rank[+e];
      if (!emst.empty()) emst_edges |= unsigned{emst[+e] != 0} << k;
    }
    tet.faces = static_cast<std::uint8_t>(faces);
    tet.egh_facets = static_cast<std::uint8_t>(egh_facets);
    tet.emst_edges = static_cast<std::uint8_t>(emst_edges);
    if (faces != 0) show_faces(tet);
  }
}

std::uint32_t ManifoldSolid::longest_rank(TetId t, unsigned facets) const {
  std::uint32_t longest = 0;
  for (const std::uint8_t k : kEdgesOfFacets[facets]) longest = std::max(longest, rank(t, k));
  return longest;
}

Flags ManifoldSolid::solid() const {
  Flags solid(complex_->tet_count(), 0);
  for (std::size_t t = 0; t < tets_.size(); ++t) solid[t] = tets_[t].solid;
  return solid;
}

std::vector<VertexId> ManifoldSolid::hidden_vertices() const {
  std::vector<VertexId> hidden;
  for (std::uint32_t v = 0; v < vertex_on_boundary_.size() && hidden.size() < hidden_; ++v) {
    if (!vertex_on_boundary_[v]) hidden.push_back(VertexId{v});
  }
  return hidden;
}

std::optional<std::string> broken_invariant(const ManifoldSolid& solid) {
  const TetComplex& complex = solid.complex();
  const Boundary anew(complex, solid.solid());
  for (std::uint32_t i = 0; i < complex.finite_tet_count(); ++i) {
    const TetId t{i};
    if (!solid.solid(t)) continue;
    const std::string which = "tetrahedron " + std::to_string(i);
    if (solid.faces(t) != anew.faces(t)) return which + " has wrong faces";
    for (int corner = 0; corner < 4; ++corner) {
      if (solid.corner_on_boundary(t, corner) == anew.corner_on_boundary(t, corner)) continue;
      return "corner " + std::to_string(corner) + " of " + which + " is wrongly marked";
    }
    for (int k = 0; k < 6; ++k) {
      if (solid.edge_on_boundary(t, k) == anew.edge_on_boundary(t, k)) continue;
      return "edge " + std::to_string(k) + " of " + which + " is wrongly marked";
    }
  }
  if (solid.hidden_vertices() != anew.hidden_vertices() ||
      solid.hidden_count() != anew.hidden_count()) {
    return "the hidden vertices are wrong";
  }
  return std::nullopt;
}

}  // namespace tetsculpt
