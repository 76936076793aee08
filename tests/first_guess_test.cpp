// The spreading of labels against its definition: again and again the node of the greatest
// certainty, found by looking at all.
#include "sculpt/first_guess.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
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

struct Belief {
  float inside = 0;
  float outside = 0;
  float certainty() const {
    return inside > 0 && outside > 0 ? std::fabs(inside - outside) - 1 : std::max(inside, outside);
  }
};

/// What the labelled nodes say about one that is not.
Belief belief(const Input& input, std::span<const Side> sides, Node x) {
  Belief sum;
  const auto hear = [&](Node from, bool same, float strength) {
    if (from == x || sides[from] == Side::kUnknown) return;
    float& evidence = (sides[from] == Side::kInside) == same ? sum.inside : sum.outside;
    evidence = std::max(evidence, strength);
  };
  for (const LabelGraph::Arc& arc : input.graph.arcs_of(x)) {
    const float cosine = input.overlap[+arc.triangle];
    hear(arc.head, cosine > 0, cosine > 0 ? cosine : -cosine / 2);
  }
  for (const PolePair& pair : input.pairs) {
    const Node a = input.graph.node_of_tet[+pair.first];
    const Node b = input.graph.node_of_tet[+pair.second];
    if (a == x) hear(b, false, static_cast<float>(pair.strength));
    if (b == x) hear(a, false, static_cast<float>(pair.strength));
  }
  return sum;
}

std::vector<Side> by_definition(const Input& input) {
  std::vector<Side> sides(input.graph.node_count(), Side::kUnknown);
  sides[LabelGraph::kOutside] = Side::kOutside;
  for (;;) {
    std::optional<Node> best;
    Belief most;
    for (Node x = 0; x < sides.size(); ++x) {
      if (sides[x] != Side::kUnknown) continue;
      const Belief b = belief(input, sides, x);
      if (b.inside == 0 && b.outside == 0) continue;
      if (best && b.certainty() <= most.certainty()) continue;
      best = x;
      most = b;
    }
    if (!best) return sides;
    sides[*best] = most.inside > most.outside ? Side::kInside : Side::kOutside;
  }
}

TEST_CASE("always the most certain node next, of equals the lowest") {
  std::size_t inside = 0, outside = 0;
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (const std::uint64_t seed : {1u, 2u}) {
      const Input input = random_input(s, seed);
      if (input.graph.node_count() > 400) continue;  // the definition is cubic
      INFO(set, ", evidence of seed ", seed);
      const auto guess = first_guess(input.graph, input.overlap, input.pairs);
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
