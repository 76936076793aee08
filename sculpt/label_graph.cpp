// Most facets of a Delaunay complex lie deep inside or outside: on surface samples of 10^4 to 10^6
// points joining across them leaves 0.3 to 2 nodes per point of 5 to 8 tetrahedra, at the same
// labels (figures in bench/RESULTS.md). Whatever runs over nodes afterwards is so much faster.
#include "sculpt/label_graph.h"

#include <numeric>

#include "kernel/disjoint_sets.h"

namespace tetsculpt {
namespace {

/// Cosine of the angle at which spheres meet from which they count as one.
constexpr float kSameSide = 0.99f;

/// One contradicted vertex in so many is not worth a second look.
constexpr std::size_t kTolerated = 1024;

/// A facet that may lie between two nodes.
struct Border {
  TriangleId triangle;
  TetId first;
  TetId second;
};

/// Unites the tetrahedra on both sides of every triangle that joins, and lists the other triangles.
/// The outside is the first member, before the finite tetrahedra.
LargeArray<Border> join(const TetComplex& complex, std::span<const float> overlap,
                        const Flags& alone, DisjointSets& sets) {
  LargeArray<Border> borders;
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const Facet f = complex.facet(TriangleId{t});
    const TetId second = complex.neighbor(f.tet, f.corner);
    if (!(overlap[t] > kSameSide) || (!alone.empty() && (alone[+f.tet] || alone[+second]))) {
      borders.push_back({TriangleId{t}, f.tet, second});
    } else {
      sets.unite(1 + +f.tet, complex.finite(second) ? 1 + +second : 0);
    }
  }
  return borders;
}

/// A set's smallest member is its representative, so the node of an earlier one is known.
void number_nodes(const TetComplex& complex, DisjointSets& sets, LabelGraph& graph) {
  const std::size_t finite = complex.finite_tet_count();
  graph.tets_in.assign(1, static_cast<std::uint32_t>(complex.tet_count() - finite));
  graph.node_of_tet.assign(complex.tet_count(), LabelGraph::kOutside);
  for (std::size_t t = 0; t < finite; ++t) {
    const std::size_t first = sets.find(1 + t);
    LabelGraph::Node& node = graph.node_of_tet[t];
    if (first == 1 + t) {
      node = static_cast<LabelGraph::Node>(graph.tets_in.size());
      graph.tets_in.push_back(0);
    } else {
      node = first == 0 ? LabelGraph::kOutside : graph.node_of_tet[first - 1];
    }
    ++graph.tets_in[node];
  }
}

/// Calls visit with each border that does lie between two nodes, and with these.
template <class Visit>
void for_each_border(std::span<const Border> borders, const LabelGraph& graph, Visit&& visit) {
  for (const Border& border : borders) {
    const LabelGraph::Node a = graph.node_of_tet[+border.first];
    const LabelGraph::Node b = graph.node_of_tet[+border.second];
    if (a != b) visit(border.triangle, a, b);
  }
}

}  // namespace

LabelGraph label_graph(const TetComplex& complex, std::span<const float> overlap,
                       const Flags& alone) {
  LabelGraph graph;
  DisjointSets sets(1 + complex.finite_tet_count());
  const LargeArray<Border> borders = join(complex, overlap, alone, sets);
  number_nodes(complex, sets, graph);
  graph.first.assign(graph.node_count() + 1, 0);
  for_each_border(borders, graph, [&](TriangleId, LabelGraph::Node a, LabelGraph::Node b) {
    ++graph.first[a + 1];
    ++graph.first[b + 1];
  });
  std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
  graph.arcs.resize(graph.first.back());
  LargeArray<std::uint32_t> next(graph.first.begin(), graph.first.end() - 1);
  for_each_border(borders, graph, [&](TriangleId t, LabelGraph::Node a, LabelGraph::Node b) {
    const std::uint32_t there = next[a]++;
    const std::uint32_t back = next[b]++;
    graph.arcs[there] = {b, back, t, overlap[+t]};
    graph.arcs[back] = {a, there, t, overlap[+t]};
  });
  return graph;
}

Flags contradicted_tets(const TetComplex& complex, const LabelGraph& graph,
                        std::span<const PolePair> pairs) {
  Flags contradicted(pairs.size(), 0);
  std::size_t count = 0;
  for (std::size_t v = 0; v < pairs.size(); ++v) {
    const PolePair& pair = pairs[v];
    contradicted[v] =
        pair.strength > 0 && graph.node_of_tet[+pair.first] == graph.node_of_tet[+pair.second];
    count += contradicted[v];
  }
  Flags flags(complex.tet_count(), 0);
  if (count <= pairs.size() / kTolerated) return flags;
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    for (const VertexId v : complex.vertices(TetId{t})) {
      if (v != kInfinite && contradicted[+v]) flags[t] = 1;
    }
  }
  return flags;
}

}  // namespace tetsculpt
