#include "kernel/emst.h"

#include "kernel/disjoint_sets.h"

namespace tetsculpt {

std::vector<EdgeId> emst(const TetComplex& complex, std::span<const EdgeId> by_length) {
  std::vector<EdgeId> tree;
  if (complex.vertex_count() == 0) return tree;
  tree.reserve(complex.vertex_count() - 1);
  DisjointSets parts(complex.vertex_count());
  for (const EdgeId e : by_length) {
    const auto [a, b] = complex.vertices(e);
    if (parts.unite(+a, +b)) tree.push_back(e);
    if (tree.size() + 1 == complex.vertex_count()) break;
  }
  return tree;
}

std::vector<EdgeId> nearest_neighbor_graph(const TetComplex& complex,
                                           std::span<const EdgeId> by_length) {
  std::vector<EdgeId> graph;
  std::vector<bool> has_nearest(complex.vertex_count(), false);
  for (const EdgeId e : by_length) {
    const auto [a, b] = complex.vertices(e);
    if (has_nearest[+a] && has_nearest[+b]) continue;
    has_nearest[+a] = has_nearest[+b] = true;
    graph.push_back(e);
  }
  return graph;
}

}  // namespace tetsculpt
