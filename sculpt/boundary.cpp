#include "sculpt/boundary.h"

#include <algorithm>
#include <utility>

#include "sculpt/exposure.h"

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
      edge_on_boundary_(complex.edge_count(), false),
      vertex_on_boundary_(complex.vertex_count(), false),
      hidden_(complex.vertex_count()) {
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const Facet f = complex.facet(TriangleId{t});
    if (solid_[+f.tet] != solid_[+complex.neighbor(f.tet, f.corner)]) add(f);
  }
}

namespace {

/// Edges both of whose facets change sides alike when a tetrahedron is flipped, by its facets on
/// the boundary: only their triangles change in number, by two.
struct ChangingEdges {
  std::uint8_t count = 0;
  std::array<std::uint8_t, 6> edges{};
};
constexpr std::array<ChangingEdges, 16> kChangingEdges = [] {
  std::array<ChangingEdges, 16> table{};
  for (unsigned facets = 0; facets < 16; ++facets) {
    for (std::uint8_t k = 0; k < 6; ++k) {
      const auto [i, j] = kEdgeCorners[5 - k];  // the facets that hold edge k
      if ((facets >> i & 1) != (facets >> j & 1)) continue;
      table[facets].edges[table[facets].count++] = k;
    }
  }
  return table;
}();

/// A simplex has so many boundary triangles more: 1 if that brings it to the boundary, -1 if that
/// takes it off, 0 if neither.
int change(std::uint32_t& triangles, int more) {
  const bool before = triangles != 0;
  triangles += static_cast<std::uint32_t>(more);
  return (triangles != 0) - before;
}

}  // namespace

inline int Boundary::count(EdgeId e, int more) {
  const int change = tetsculpt::change(triangles_at_edge_[+e], more);
  if (change != 0) edge_on_boundary_[+e] = change > 0;
  return change;
}

inline int Boundary::count(VertexId v, int more) {
  const int change = tetsculpt::change(triangles_at_vertex_[+v], more);
  if (change != 0) vertex_on_boundary_[+v] = change > 0;
  return change;
}

/// Puts a triangle on the boundary.
void Boundary::add(Facet f) {
  const Facet other = complex_->across(f.tet, f.corner);
  faces_[+f.tet] = static_cast<std::uint8_t>(faces_[+f.tet] | 1u << f.corner);
  faces_[+other.tet] = static_cast<std::uint8_t>(faces_[+other.tet] | 1u << other.corner);
  const auto& facet = kFacetCorners[static_cast<std::size_t>(f.corner)];
  ++euler_characteristic_;
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeId e = complex_->edge(f.tet, kEdgeOfCorners[facet[i]][facet[(i + 1) % 3]]);
    euler_characteristic_ -= count(e, 1);
    const int appeared = count(complex_->vertices(f.tet)[facet[i]], 1);
    euler_characteristic_ += appeared;
    hidden_ -= static_cast<std::size_t>(appeared);
  }
}

void Boundary::remove(TetId t) {
  assert(solid(t));
  flip(t);
}

void Boundary::flip(TetId t) {
  assert(complex_->finite(t));
  const unsigned facets = faces_[+t];
  solid_[+t] ^= 1;
  faces_[+t] = static_cast<std::uint8_t>(facets ^ 15);
  int vertices = 0;
  for (int i = 0; i < 4; ++i) {
    const Facet other = complex_->across(t, i);
    faces_[+other.tet] = static_cast<std::uint8_t>(faces_[+other.tet] ^ 1u << other.corner);
    // All facets but that opposite the corner hold it.
    const int more = 3 - 2 * facet_count(facets & ~(1u << i));
    vertices += count(complex_->vertices(t)[static_cast<std::size_t>(i)], more);
  }
  int edges = 0;
  const ChangingEdges& changing = kChangingEdges[facets];
  for (std::size_t n = 0; n < changing.count; ++n) {
    const int k = changing.edges[n];
    const std::uint8_t facet = kEdgeCorners[static_cast<std::size_t>(5 - k)][0];
    const int more = (facets >> facet & 1) != 0 ? -2 : 2;
    edges += count(complex_->edge(t, k), more);
  }
  hidden_ -= static_cast<std::size_t>(vertices);
  euler_characteristic_ += vertices - edges + 4 - 2 * facet_count(facets);
}

std::vector<VertexId> Boundary::hidden_vertices() const {
  std::vector<VertexId> hidden;
  for (std::uint32_t v = 0; v < triangles_at_vertex_.size() && hidden.size() < hidden_; ++v) {
    if (triangles_at_vertex_[v] == 0) hidden.push_back(VertexId{v});
  }
  return hidden;
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
