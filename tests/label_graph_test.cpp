// Nodes are the sets of tetrahedra that are connected across facets of deep overlap; arcs are the
// facets between them.
#include "sculpt/label_graph.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

constexpr float kSameSide = 0.99f;

struct Input {
  LargeArray<float> overlap;
  Flags alone;
};

Input random_input(const TetComplex& complex, std::uint64_t seed) {
  point_sets::Random random(seed);
  Input input;
  for (std::size_t t = 0; t < complex.triangle_count(); ++t) {
    input.overlap.push_back(random.below(2) == 0 ? 1.0f : 0.5f);
  }
  for (std::size_t t = 0; t < complex.tet_count(); ++t) {
    input.alone.push_back(complex.finite(TetId{static_cast<std::uint32_t>(t)}) &&
                          random.below(10) == 0);
  }
  return input;
}

/// Per tetrahedron one member of its set, by flooding; infinite ones are in one set.
std::vector<std::uint32_t> flooded(const TetComplex& complex, const Input& input) {
  const auto count = static_cast<std::uint32_t>(complex.tet_count());
  std::vector<std::uint32_t> first(count, count);
  std::vector<TetId> set;
  const auto add = [&](TetId t, std::uint32_t root) {
    if (first[+t] != count) return;
    first[+t] = root;
    set.push_back(t);
  };
  const auto flood = [&](std::uint32_t root) {
    for (std::size_t k = 0; k < set.size(); ++k) {
      const TetId t = set[k];
      for (int i = 0; i < 4; ++i) {
        const TetId u = complex.neighbor(t, i);
        if (!complex.finite(t) && !complex.finite(u)) continue;
        if (input.alone[+t] || input.alone[+u]) continue;
        if (input.overlap[+complex.triangle(t, i)] > kSameSide) add(u, root);
      }
    }
    set.clear();
  };
  const auto outside = static_cast<std::uint32_t>(complex.finite_tet_count());
  for (std::uint32_t t = outside; t < count; ++t) add(TetId{t}, outside);
  flood(outside);
  for (std::uint32_t t = 0; t < outside; ++t) {
    add(TetId{t}, t);
    flood(t);
  }
  return first;
}

void check_nodes(const TetComplex& complex, const LabelGraph& graph,
                 const std::vector<std::uint32_t>& first) {
  std::vector<std::uint32_t> size(graph.node_count(), 0);
  for (std::size_t t = 0; t < first.size(); ++t) {
    REQUIRE(graph.node_of_tet[t] < graph.node_count());
    REQUIRE(graph.node_of_tet[t] == graph.node_of_tet[first[t]]);
    const bool with_infinity = first[t] == complex.finite_tet_count();
    REQUIRE((graph.node_of_tet[t] == LabelGraph::kOutside) == with_infinity);
    ++size[graph.node_of_tet[t]];
  }
  std::vector<std::uint32_t> roots(first);
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  REQUIRE(roots.size() == graph.node_count());
  for (std::size_t x = 0; x < size.size(); ++x) REQUIRE(graph.tets_in[x] == size[x]);
}

void check_arcs(const TetComplex& complex, std::span<const float> overlap,
                const LabelGraph& graph) {
  std::size_t between = 0;
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const Facet f = complex.facet(TriangleId{t});
    const TetId other = complex.neighbor(f.tet, f.corner);
    between += graph.node_of_tet[+f.tet] != graph.node_of_tet[+other];
  }
  REQUIRE(graph.arcs.size() == 2 * between);
  for (LabelGraph::Node x = 0; x < graph.node_count(); ++x) {
    for (std::uint32_t a = graph.first[x]; a < graph.first[x + 1]; ++a) {
      const LabelGraph::Arc& arc = graph.arcs[a];
      REQUIRE(arc.head != x);
      REQUIRE(graph.arcs[arc.mate].mate == a);
      REQUIRE(graph.arcs[arc.mate].head == x);
      REQUIRE(+graph.arcs[arc.mate].triangle == +arc.triangle);
      REQUIRE(arc.overlap == overlap[+arc.triangle]);
      const Facet f = complex.facet(arc.triangle);
      const auto one = graph.node_of_tet[+f.tet];
      const auto two = graph.node_of_tet[+complex.neighbor(f.tet, f.corner)];
      REQUIRE(((one == x && two == arc.head) || (two == x && one == arc.head)));
    }
  }
}

TEST_CASE("random overlaps, some tetrahedra alone") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      INFO(set, ", overlaps of seed ", seed);
      const Input input = random_input(s.complex, seed);
      const LabelGraph graph = label_graph(s.complex, input.overlap, input.alone);
      check_nodes(s.complex, graph, flooded(s.complex, input));
      check_arcs(s.complex, input.overlap, graph);
    }
  }
}

}  // namespace
}  // namespace tetsculpt
