#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "kernel/ids.h"
#include "kernel/large_array.h"
#include "kernel/lifted_hull.h"
#include "kernel/point.h"
#include "kernel/simplices.h"
#include "kernel/tet_corners.h"

/// The Delaunay complex with explicit vertices, edges, triangles and tetrahedra: the paper's data
/// structure (section 4). It knows no coordinates. Infinite tetrahedra, with kInfinite as one
/// corner, close it outside the convex hull: finite ones have ids below finite_tet_count().
namespace tetsculpt {

/// A facet as one tetrahedron sees it.
struct Facet {
  TetId tet;
  int corner;  ///< the one opposite the facet
};

class TetComplex {
 public:
  /// No simplex at all.
  TetComplex() = default;
  /// Takes the tetrahedra of a hull over `vertex_count` points, their corners in the order that
  /// LiftedHull promises, and finds its triangles and edges. `progress` is told now and then which
  /// share of that is done, from 0 to 1, and may throw. The result does not depend on `threads`.
  /// Cost: linear; 8 to 10 words per tetrahedron.
  TetComplex(LiftedHull hull, std::size_t vertex_count,
             const std::function<void(double)>& progress = {}, int threads = 1);

  std::size_t vertex_count() const { return tet_of_vertex_.size(); }
  std::size_t edge_count() const { return simplices_.edges.size(); }
  std::size_t triangle_count() const { return simplices_.facet_of_triangle.size(); }
  std::size_t finite_tet_count() const { return hull_.finite_count; }
  /// Finite and infinite tetrahedra.
  std::size_t tet_count() const { return hull_.tets.size(); }

  bool finite(TetId t) const { return +t < hull_.finite_count; }
  const std::array<VertexId, 4>& vertices(TetId t) const { return hull_.tets[+t]; }
  /// The facet opposite `corner`, as the tetrahedron on its other side sees it.
  Facet across(TetId t, int corner) const {
    const FacetHandle h = hull_.neighbors[+t][static_cast<std::size_t>(corner)];
    return {TetId{h >> 2}, static_cast<int>(h & 3)};
  }
  TetId neighbor(TetId t, int corner) const { return across(t, corner).tet; }
  /// Only finite triangles and edges have ids: precondition, their corners are finite.
  TriangleId triangle(TetId t, int corner) const {
    return simplices_.triangles_of_tet[+t][static_cast<std::size_t>(corner)];
  }
  EdgeId edge(TetId t, int edge) const {
    return simplices_.edges_of_tet[+t][static_cast<std::size_t>(edge)];
  }

  /// The triangle in its first tetrahedron, which is finite; across() gives the other one.
  Facet facet(TriangleId t) const {
    const FacetHandle h = simplices_.facet_of_triangle[+t];
    return {TetId{h >> 2}, static_cast<int>(h & 3)};
  }
  /// Corners, counterclockwise from outside the first tetrahedron.
  std::array<VertexId, 3> vertices(TriangleId t) const;
  /// Its edges; edge i is opposite corner i.
  std::array<EdgeId, 3> edges(TriangleId t) const;

  /// The end points, lower id first.
  const std::array<VertexId, 2>& vertices(EdgeId e) const { return simplices_.edges[+e].vertices; }
  /// One triangle at the edge.
  TriangleId triangle(EdgeId e) const { return simplices_.edges[+e].triangle; }
  /// Some finite tetrahedron at the vertex.
  TetId tet(VertexId v) const { return tet_of_vertex_[+v]; }

  /// Turns around the edge through all its tetrahedra, finite or not, starting at the one triangle
  /// it stores: calls visit(Facet, VertexId) once per triangle at the edge, with that triangle's
  /// third vertex (kInfinite outside the hull), in cyclic order. Stops early when visit returns
  /// false.
  template <class Visit>
  void turn(EdgeId e, Visit&& visit) const;

 private:
  LiftedHull hull_;
  Simplices simplices_;
  LargeArray<TetId> tet_of_vertex_;
};

/// The first violation of what this header promises, if any. Cost: linear, in exact arithmetic.
std::optional<std::string> broken_invariant(const TetComplex& complex,
                                            std::span<const Point3> points);

/// The corner of a tetrahedron at which v is. Precondition: v is one of its corners.
inline int corner_of(const std::array<VertexId, 4>& tet, VertexId v) {
  assert(tet[0] == v || tet[1] == v || tet[2] == v || tet[3] == v);
  return tet[0] == v ? 0 : tet[1] == v ? 1 : tet[2] == v ? 2 : 3;
}

template <class Visit>
void TetComplex::turn(EdgeId e, Visit&& visit) const {
  const auto& [va, vb] = simplices_.edges[+e].vertices;
  const Facet first = facet(simplices_.edges[+e].triangle);
  TetId t = first.tet;
  // The two other corners: leave through the facet opposite `behind`, which holds `ahead`.
  int behind = first.corner;
  int ahead = 6 - corner_of(hull_.tets[+t], va) - corner_of(hull_.tets[+t], vb) - behind;
  do {
    const VertexId third = hull_.tets[+t][static_cast<std::size_t>(ahead)];
    if (!visit(Facet{t, behind}, third)) return;
    const Facet next = across(t, behind);
    t = next.tet;
    behind = corner_of(hull_.tets[+t], third);
    ahead = next.corner;
  } while (t != first.tet);
}

}  // namespace tetsculpt
