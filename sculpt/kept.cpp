#include "sculpt/kept.h"

#include <algorithm>
#include <cstddef>

namespace tetsculpt {

PointGraph kept_edges(const TetComplex& complex, const Flags& edges,
                      std::span<const std::uint32_t> index) {
  PointGraph graph;
  graph.edges.reserve(static_cast<std::size_t>(std::count(edges.begin(), edges.end(), 1)));
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    if (!edges[e]) continue;
    const auto& [a, b] = complex.vertices(EdgeId{e});
    graph.edges.push_back({std::min(index[+a], index[+b]), std::max(index[+a], index[+b])});
  }
  return graph;
}

PointGraph kept_hypergraph(const TetComplex& complex, const Flags& edges, const Flags& triangles,
                           std::span<const std::uint32_t> index) {
  PointGraph graph = kept_edges(complex, edges, index);
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    if (!triangles[t]) continue;
    const auto [a, b, c] = complex.vertices(TriangleId{t});
    graph.triangles.push_back({index[+a], index[+b], index[+c]});
  }
  return graph;
}

TetMesh kept_tetrahedra(const TetComplex& complex, const Flags& solid,
                        std::span<const std::uint32_t> index) {
  TetMesh mesh;
  mesh.tetrahedra.reserve(complex.finite_tet_count());
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    const auto& [a, b, c, d] = complex.vertices(TetId{t});
    mesh.tetrahedra.push_back({index[+a], index[+b], index[+c], index[+d]});
  }
  mesh.inside.assign(solid.begin(),
                     solid.begin() + static_cast<std::ptrdiff_t>(complex.finite_tet_count()));
  return mesh;
}

}  // namespace tetsculpt
