#pragma once

#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/edge_order.h"
#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"
#include "sculpt/constraints.h"
#include "sculpt/exposure.h"

/// The solid of the paper's method, whose boundary is a 2-manifold at all times.
namespace tetsculpt {

/// A set of finite tetrahedra of a complex, and what holds it back, laid out for speed: all that is
/// asked of a tetrahedron is in one line of the cache. On a 2-manifold an edge has two triangles or
/// none, so a bit tells all that a Boundary has to count. Edges go by rank: their place in
/// edges_by_length. All updates and queries take constant time and allocate nothing.
class ManifoldSolid {
 public:
  /// All finite tetrahedra. Keeps a reference to the complex, which must outlive it.
  ManifoldSolid(std::span<const Point3> points, const TetComplex& complex,
                const Constraints& constraints);

  const TetComplex& complex() const { return *complex_; }
  bool solid(TetId t) const { return complex_->finite(t) && tets_[+t].solid; }
  /// As the complex has them; only finite tetrahedra have them here.
  const std::array<VertexId, 4>& vertices(TetId t) const { return tets_[+t].vertices; }
  Facet across(TetId t, int corner) const { return facet(tets_[+t].across[index(corner)]); }
  TetId neighbor(TetId t, int corner) const { return across(t, corner).tet; }
  /// Place of an edge in edges_by_length: the longer, the higher.
  std::uint32_t rank(TetId t, int edge) const { return tets_[+t].ranks[index(edge)]; }
  /// The longest edge of some facets, a bit each, at least one.
  std::uint32_t longest_rank(TetId t, unsigned facets) const;

  /// The facets of a solid tetrahedron that are on the boundary, a bit per opposite corner.
  std::uint8_t faces(TetId t) const { return tets_[+t].faces; }
  bool corner_on_boundary(TetId t, int corner) const {
    return vertex_on_boundary_[+tets_[+t].vertices[index(corner)]];
  }
  bool edge_on_boundary(TetId t, int edge) const { return edge_on_boundary_[rank(t, edge)]; }
  /// Vertices that are not on the boundary.
  std::size_t hidden_count() const { return hidden_; }
  std::vector<VertexId> hidden_vertices() const;

  /// The facets in the EGH, a bit per opposite corner.
  std::uint8_t egh_facets(TetId t) const { return tets_[+t].egh_facets; }
  bool in_emst(TetId t, int edge) const { return (tets_[+t].emst_edges >> edge & 1) != 0; }

  /// Takes a solid tetrahedron off that the basic rules allow to go. Calls changed(u) for each
  /// tetrahedron u that has a boundary face more.
  template <class Changed>
  void remove(TetId t, Changed&& changed);
  /// Takes three off at once that are a pseudo-prism (sculpt/pseudo_prism.h). Some of which it
  /// tells may be of the three themselves.
  template <class Changed>
  void remove_prism(const std::array<TetId, 3>& chain, Changed&& changed);
  /// One flag per tetrahedron of the complex.
  Flags solid() const;

  /// A number that the user of this keeps with a finite tetrahedron; zero at first.
  std::uint32_t& note(TetId t) { return tets_[+t].note; }
  std::uint32_t note(TetId t) const { return tets_[+t].note; }

  /// Has what is stored of a finite tetrahedron, or of its neighbours, on its way to the cache.
  void prefetch(TetId t) const { __builtin_prefetch(&tets_[+t]); }
  void prefetch_neighbors(TetId t) const {
    for (const FacetHandle h : tets_[+t].across) {
      if (const TetId u = facet(h).tet; complex_->finite(u)) prefetch(u);
    }
  }

 private:
  struct alignas(64) Tet {
    std::array<FacetHandle, 4> across;
    std::array<std::uint32_t, 6> ranks;
    std::array<VertexId, 4> vertices;
    std::uint32_t note;
    std::uint8_t faces;
    std::uint8_t egh_facets;
    std::uint8_t emst_edges;
    bool solid;
  };
  static_assert(sizeof(Tet) == 64);

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static Facet facet(FacetHandle h) { return {TetId{h >> 2}, static_cast<int>(h & 3)}; }
  void copy_tets(std::span<const EdgeId> by_length, const Constraints& constraints);
  /// Puts a vertex on the boundary.
  void show(VertexId v) {
    hidden_ -= !vertex_on_boundary_[+v];
    vertex_on_boundary_[+v] = true;
  }
  void show_faces(const Tet& tet);
  template <class Changed>
  void take_off(Tet& tet, Changed&& changed);

  const TetComplex* complex_;
  LargeArray<Tet> tets_;  ///< the finite ones
  std::vector<bool> edge_on_boundary_;
  std::vector<bool> vertex_on_boundary_;
  std::size_t hidden_;
};

/// The edges that are on none of some facets, a bit each.
inline constexpr std::array<std::uint8_t, 16> kEdgesInside = [] {
  std::array<std::uint8_t, 16> table{};
  for (unsigned facets = 0; facets < 16; ++facets) {
    for (std::size_t k = 0; k < 6; ++k) {
      // An edge is on the two facets opposite the corners that it does not touch.
      const auto [i, j] = kEdgeCorners[5 - k];
      const unsigned touched = (facets >> i | facets >> j) & 1;
      table[facets] = static_cast<std::uint8_t>(table[facets] | (1 - touched) << k);
    }
  }
  return table;
}();

/// Takes a tetrahedron off and brings out what it hid.
template <class Changed>
void ManifoldSolid::take_off(Tet& tet, Changed&& changed) {
  assert(tet.solid && tet.faces != 0 && facet_count(tet.faces) <= 2);
  tet.solid = false;
  for (unsigned inside = 15u & ~tet.faces; inside != 0; inside &= inside - 1) {
    const Facet other = facet(tet.across[index(std::countr_zero(inside))]);
    Tet& neighbor = tets_[+other.tet];
    neighbor.faces = static_cast<std::uint8_t>(neighbor.faces | 1u << other.corner);
    changed(other.tet);
  }
  for (unsigned hidden = kEdgesInside[tet.faces]; hidden != 0; hidden &= hidden - 1) {
    edge_on_boundary_[tet.ranks[index(std::countr_zero(hidden))]] = true;
  }
  if (std::has_single_bit(tet.faces)) show(tet.vertices[index(std::countr_zero(tet.faces))]);
}

template <class Changed>
void ManifoldSolid::remove(TetId t, Changed&& changed) {
  Tet& tet = tets_[+t];
  take_off(tet, changed);
  if (std::has_single_bit(tet.faces)) return;
  edge_on_boundary_[tet.ranks[index(5 - opposite_edge(tet.faces))]] = false;
}

template <class Changed>
void ManifoldSolid::remove_prism(const std::array<TetId, 3>& chain, Changed&& changed) {
  for (const TetId t : chain) take_off(tets_[+t], changed);
}

/// Compares all that is kept of the boundary with one made anew. Cost: linear.
std::optional<std::string> broken_invariant(const ManifoldSolid& solid);

}  // namespace tetsculpt
