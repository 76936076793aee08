#include "sculpt/boundary.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace tetsculpt {

Flags all_finite(const TetComplex& complex) {
  Flags solid(complex.tet_count(), 0);
  std::fill_n(solid.begin(), complex.finite_tet_count(), std::uint8_t{1});
  return solid;
}

Boundary::Boundary(const TetComplex& complex) : Boundary(complex, all_finite(complex)) {}

Boundary::Boundary(const TetComplex& complex, Flags solid)
    : complex_(&complex),
      solid_(std::move(solid)),
      faces_(complex.tet_count(), 0),
      triangles_at_edge_(complex.edge_count(), 0),
      triangles_at_vertex_(complex.vertex_count(), 0),
      hidden_(complex.vertex_count()) {
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const Facet f = complex.facet(TriangleId{t});
    if (solid_[+f.tet] != solid_[+complex.neighbor(f.tet, f.corner)]) toggle(f);
  }
}

/// Puts a triangle on the boundary or takes it off.
void Boundary::toggle(Facet f) {
  const TetId t = f.tet;
  const auto& facet = kFacetCorners[static_cast<std::size_t>(f.corner)];
  const auto& v = complex_->vertices(t);
  const Facet other = complex_->across(t, f.corner);
  faces_[+t] = static_cast<std::uint8_t>(faces_[+t] ^ 1u << f.corner);
  faces_[+other.tet] = static_cast<std::uint8_t>(faces_[+other.tet] ^ 1u << other.corner);
  const bool on = on_boundary(f);
  const std::uint32_t change = on ? 1u : 0xffffffffu;
  /// True if the simplex comes to the boundary or leaves it.
  const auto counted = [&](std::uint32_t& count) {
    const std::uint32_t before = std::exchange(count, count + change);
    return before == 0 || count == 0;
  };
  int appeared = 1;  // the triangle, less the edges, plus the vertices
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeId e = complex_->edge(t, kEdgeOfCorners[facet[i]][facet[(i + 1) % 3]]);
    appeared -= counted(triangles_at_edge_[+e]);
    if (!counted(triangles_at_vertex_[+v[facet[i]]])) continue;
    ++appeared;
    on ? --hidden_ : ++hidden_;
  }
  euler_characteristic_ += on ? appeared : -appeared;
}

void Boundary::remove(TetId t) {
  assert(solid(t));
  flip(t);
}

void Boundary::flip(TetId t) {
  assert(complex_->finite(t));
  solid_[+t] ^= 1;
  for (int i = 0; i < 4; ++i) toggle({t, i});
}

std::vector<VertexId> Boundary::hidden_vertices() const {
  std::vector<VertexId> hidden;
  for (std::uint32_t v = 0; v < triangles_at_vertex_.size() && hidden.size() < hidden_; ++v) {
    if (triangles_at_vertex_[v] == 0) hidden.push_back(VertexId{v});
  }
  return hidden;
}

Exposure exposure(const Boundary& boundary, TetId t) {
  const TetComplex& complex = boundary.complex();
  const unsigned faces = boundary.faces(t);
  Exposure e;
  e.faces = facet_count(faces);
  e.facets = static_cast<std::uint8_t>(faces);
  if (e.faces == 1) {
    const auto opposite = static_cast<std::size_t>(std::countr_zero(faces));
    e.removable = !boundary.on_boundary(complex.vertices(t)[opposite]);
  } else if (e.faces == 2) {
    // Facets i and j are opposite corners i and j: their common edge joins the other two corners,
    // and the edge opposite to it joins i and j.
    const auto i = static_cast<std::size_t>(std::countr_zero(faces));
    const auto j = static_cast<std::size_t>(std::countr_zero(faces & (faces - 1)));
    e.opposite_edge = kEdgeOfCorners[i][j];
    e.removable = !boundary.on_boundary(complex.edge(t, e.opposite_edge));
  }
  return e;
}

std::vector<std::array<VertexId, 3>> boundary_triangles(const TetComplex& complex,
                                                        const Flags& solid) {
  std::vector<std::array<VertexId, 3>> triangles;
  triangles.reserve(2 * complex.vertex_count());
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    if (!solid[t]) continue;
    const auto& v = complex.vertices(TetId{t});
    for (int i = 0; i < 4; ++i) {
      if (solid[+complex.neighbor(TetId{t}, i)]) continue;
      const auto& c = kFacetCorners[static_cast<std::size_t>(i)];
      triangles.push_back({v[c[0]], v[c[1]], v[c[2]]});
    }
  }
  return triangles;
}

std::optional<std::string> broken_invariant(const Boundary& boundary) {
  const TetComplex& complex = boundary.complex();
  Flags triangle(complex.triangle_count(), 0);
  Flags edge(complex.edge_count(), 0);
  Flags vertex(complex.vertex_count(), 0);
  for (std::uint32_t t = 0; t < triangle.size(); ++t) {
    const Facet f = complex.facet(TriangleId{t});
    if (boundary.solid(f.tet) == boundary.solid(complex.neighbor(f.tet, f.corner))) continue;
    triangle[t] = 1;
    for (const EdgeId e : complex.edges(TriangleId{t})) edge[+e] = 1;
    for (const VertexId v : complex.vertices(TriangleId{t})) vertex[+v] = 1;
  }
  for (std::uint32_t t = 0; t < triangle.size(); ++t) {
    const Facet f = complex.facet(TriangleId{t});
    for (const Facet side : {f, complex.across(f.tet, f.corner)}) {
      if (boundary.on_boundary(side) == (triangle[t] != 0)) continue;
      return "triangle " + std::to_string(t) + " is wrongly marked";
    }
  }
  const auto count = [](const Flags& flags) {
    return std::count(flags.begin(), flags.end(), std::uint8_t{1});
  };
  if (boundary.euler_characteristic() != count(vertex) - count(edge) + count(triangle)) {
    return "the Euler characteristic is wrong";
  }
  for (std::uint32_t e = 0; e < edge.size(); ++e) {
    if (boundary.on_boundary(EdgeId{e}) != (edge[e] != 0)) {
      return "edge " + std::to_string(e) + " is wrongly counted";
    }
  }
  std::size_t hidden = 0;
  for (std::uint32_t v = 0; v < vertex.size(); ++v) {
    hidden += vertex[v] == 0;
    if (boundary.on_boundary(VertexId{v}) != (vertex[v] != 0)) {
      return "vertex " + std::to_string(v) + " is wrongly counted";
    }
  }
  if (hidden != boundary.hidden_count()) return "the hidden vertices are wrongly counted";
  return std::nullopt;
}

}  // namespace tetsculpt
