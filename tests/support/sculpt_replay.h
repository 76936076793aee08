#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "kernel/ids.h"
#include "kernel/tet_complex.h"
#include "sculpt/sculpture.h"

/// Sculpting done over again on a structure of its own: nothing but sets of corner triples, made
/// from the corners of the tetrahedra. It shares no code with sculpt/boundary and asks the complex
/// for no neighbour, edge or triangle.
namespace tetsculpt::testing {

using Corners = std::array<VertexId, 3>;          ///< a triangle, corners ascending
using EndPoints = std::pair<VertexId, VertexId>;  ///< an edge, lower id first

/// The four facets of a tetrahedron.
std::array<Corners, 4> facets_of(const std::array<VertexId, 4>& tet);
/// The three edges of a triangle.
std::array<EndPoints, 3> edges_of(const Corners& triangle);

/// The boundary of the solid.
class Replay {
 public:
  /// Starts with all finite tetrahedra.
  explicit Replay(const TetComplex& complex);

  /// Takes a tetrahedron off: its facets on the boundary leave it, the others join it.
  void remove(TetId t);

  bool on_boundary(const Corners& triangle) const { return triangles_.contains(triangle); }
  bool on_boundary(EndPoints edge) const { return triangles_at_edge_.contains(edge); }
  bool on_boundary(VertexId v) const { return triangles_at_vertex_.contains(v); }
  std::vector<Corners> boundary_facets(TetId t) const;
  std::size_t hidden_count() const {
    return complex_->vertex_count() - triangles_at_vertex_.size();
  }
  const std::set<Corners>& triangles() const { return triangles_; }

  /// v - e + f over the boundary's simplices.
  long euler_number() const;
  /// Connected components of the boundary, by union-find over its triangles.
  std::size_t components() const;

  /// Where the boundary is no 2-manifold: an edge without exactly two triangles, or a vertex whose
  /// link isn't one cycle. The first at these vertices, or at any.
  std::optional<std::string> not_manifold_at(std::span<const VertexId> vertices) const;
  std::optional<std::string> not_manifold() const;

 private:
  void toggle(const Corners& triangle);

  const TetComplex* complex_;
  std::set<Corners> triangles_;
  std::map<EndPoints, int> triangles_at_edge_;
  std::map<VertexId, std::set<Corners>> triangles_at_vertex_;
};

/// Tetrahedra that went at once: one, or the three of a pseudo-prism.
struct RemovalStep {
  std::span<const TetId> tets;
  bool hole;
};
std::vector<RemovalStep> removal_steps(const Sculpture& sculpture);
std::vector<RemovalStep> removal_steps(Sculpture&&) = delete;  // the steps refer to it

}  // namespace tetsculpt::testing
