#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernel/edge_order.h"
#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/tet_complex.h"

/// The solid being sculpted and its boundary.
namespace tetsculpt {

/// Flags the finite tetrahedra: the convex hull.
Flags all_finite(const TetComplex& complex);

/// A set of finite tetrahedra of a complex, with the triangles between it and the rest. A vertex or
/// edge is on the boundary if a boundary triangle holds it. All updates and queries take constant
/// time and allocate nothing.
class Boundary {
 public:
  /// All finite tetrahedra. Keeps a reference to the complex, which must outlive it.
  explicit Boundary(const TetComplex& complex);
  /// The flagged tetrahedra; infinite ones must not be.
  Boundary(const TetComplex& complex, Flags solid);

  const TetComplex& complex() const { return *complex_; }
  bool solid(TetId t) const { return solid_[+t] != 0; }
  const Flags& solid() const { return solid_; }
  /// The facets of a tetrahedron that are on the boundary, a bit per opposite corner.
  std::uint8_t faces(TetId t) const { return faces_[+t]; }
  bool on_boundary(Facet f) const { return (faces_[+f.tet] >> f.corner & 1) != 0; }
  bool on_boundary(EdgeId e) const { return edge_on_boundary_[+e]; }
  bool on_boundary(VertexId v) const { return vertex_on_boundary_[+v]; }
  bool corner_on_boundary(TetId t, int corner) const {
    return on_boundary(complex_->vertices(t)[static_cast<std::size_t>(corner)]);
  }
  bool edge_on_boundary(TetId t, int edge) const { return on_boundary(complex_->edge(t, edge)); }
  /// How many boundary triangles hold the vertex.
  std::size_t triangles_at(VertexId v) const { return triangles_at_vertex_[+v]; }
  /// Vertices that are not on the boundary: all their tetrahedra are solid, or none is.
  std::size_t hidden_count() const { return hidden_; }
  std::vector<VertexId> hidden_vertices() const;
  /// Vertices less edges plus triangles, of those on the boundary: for a 2-manifold twice the
  /// number of shells less twice the number of handles.
  std::int64_t euler_characteristic() const { return euler_characteristic_; }

  /// Takes a solid tetrahedron off the solid.
  void remove(TetId t);
  /// Takes a finite tetrahedron off the solid, or adds it.
  void flip(TetId t);

 private:
  void add(Facet f);
  int count(EdgeId e, int more);
  int count(VertexId v, int more);

  const TetComplex* complex_;
  Flags solid_;
  Flags faces_;
  LargeArray<std::uint32_t> triangles_at_edge_;
  LargeArray<std::uint32_t> triangles_at_vertex_;
  // The same as a bit each, in the nearest caches.
  std::vector<bool> edge_on_boundary_;
  std::vector<bool> vertex_on_boundary_;
  std::size_t hidden_;
  std::int64_t euler_characteristic_ = 0;
};

/// The boundary triangles of a set of tetrahedra, counterclockwise from outside the solid, in the
/// order of the tetrahedra.
std::vector<std::array<VertexId, 3>> boundary_triangles(const TetComplex& complex,
                                                        const Flags& solid);

/// Compares every count with one made anew. Cost: linear.
std::optional<std::string> broken_invariant(const Boundary& boundary);

}  // namespace tetsculpt
