// The spreading of labels against its definition: again and again, of all nodes, the one of the
// greatest certainty in steps of 2^-10, and of equals the one that was told last.
#include "sculpt/first_guess.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using Node = LabelGraph::Node;

struct Input {
  LargeArray<float> overlap;
  LargeArray<PolePair> pairs;
  LabelGraph graph;
};

/// Random cosines and poles on the complex of a point set. Few different numbers, so that ties are
/// many.
Input random_input(const testing::Stages& s, std::uint64_t seed) {
  point_sets::Random random(seed);
  Input input;
  for (std::size_t t = 0; t < s.complex.triangle_count(); ++t) {
    input.overlap.push_back(static_cast<float>(random.below(17)) / 8 - 1);
  }
  const auto any_tet = [&] {
    return TetId{static_cast<std::uint32_t>(random.below(s.complex.tet_count()))};
  };
  for (std::size_t v = 0; v < s.complex.vertex_count(); ++v) {
    input.pairs.push_back(
        {any_tet(), any_tet(), {0, 0, 1}, static_cast<double>(random.below(9)) / 8});
  }
  input.graph = label_graph(s.complex, input.overlap, Flags(s.complex.tet_count(), 0));
  return input;
}

/// What a node has been told by the labelled ones.
struct Belief {
  float inside = 0;
  float outside = 0;
  std::size_t last_told = 0;

  void hear(bool is_inside, float strength, std::size_t now) {
    float& evidence = is_inside ? inside : outside;
    if (strength > evidence) last_told = now;
    evidence = std::max(evidence, strength);
  }
  /// The greater, the sooner the node gets its label.
  std::pair<long, std::size_t> rank() const {
    const float certainty =
        inside > 0 && outside > 0 ? std::fabs(inside - outside) - 1 : std::max(inside, outside);
    return {std::lround(std::floor(certainty * 1024)), last_told};
  }
};

std::vector<Side> by_definition(const Input& input) {
  const std::size_t n = input.graph.node_count();
  std::vector<Side> sides(n, Side::kUnknown);
  std::vector<Belief> beliefs(n);
  std::size_t now = 0;
  for (Node x = LabelGraph::kOutside;;) {
    const bool inside = beliefs[x].inside > beliefs[x].outside;
    sides[x] = inside ? Side::kInside : Side::kOutside;
    for (const PolePair& pair : input.pairs) {
      const Node a = input.graph.node_of_tet[+pair.first];
      const Node b = input.graph.node_of_tet[+pair.second];
      if (a == b || (a != x && b != x)) continue;
      beliefs[a == x ? b : a].hear(!inside, static_cast<float>(pair.strength), ++now);
    }
    for (const LabelGraph::Arc& arc : input.graph.arcs_of(x)) {
      const float cosine = input.overlap[+arc.triangle];
      beliefs[arc.head].hear(inside == (cosine > 0), cosine > 0 ? cosine : -cosine / 2, ++now);
    }
    std::optional<Node> best;
    for (Node y = 0; y < n; ++y) {
      if (sides[y] != Side::kUnknown || beliefs[y].last_told == 0) continue;
      if (!best || beliefs[y].rank() > beliefs[*best].rank()) best = y;
    }
    if (!best) return sides;
    x = *best;
  }
}

TEST_CASE("always the most certain node next, of equals the last told") {
  std::size_t inside = 0, outside = 0;
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const std::uint64_t seed : {1u, 2u}) {
      const Input input = random_input(s, seed);
      if (input.graph.node_count() > 400) continue;  // the definition is cubic
      INFO(set, ", evidence of seed ", seed);
      const auto guess = first_guess(input.graph, input.pairs);
      const auto expected = by_definition(input);
      REQUIRE(std::ranges::equal(guess, expected));
      inside += static_cast<std::size_t>(std::ranges::count(guess, Side::kInside));
      outside += static_cast<std::size_t>(std::ranges::count(guess, Side::kOutside));
    }
  }
  CHECK(inside > 100);
  CHECK(outside > 100);
}

}  // namespace
}  // namespace tetsculpt
