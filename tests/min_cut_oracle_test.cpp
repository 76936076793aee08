// The minimum cut against a maximum flow found the plain way, by shortest augmenting paths.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "kernel/tet_complex.h"
#include "sculpt/circumspheres.h"
#include "sculpt/label_graph.h"
#include "sculpt/min_cut.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using Capacity = MinCut::Capacity;
using point_sets::Random;

/// A complex with a graph over it.
struct Scene {
  testing::Stages s;
  LabelGraph graph;
};

/// Costs of a cut.
struct Costs {
  std::vector<Capacity> facet;  ///< per triangle
  std::vector<Capacity> bias;   ///< per node, towards inside; 0 for the outside
};

/// The nodes on the two sides of a triangle.
std::array<std::size_t, 2> sides(const Scene& scene, std::uint32_t triangle) {
  const Facet f = scene.s.complex.facet(TriangleId{triangle});
  const auto& node = scene.graph.node_of_tet;
  return {node[+f.tet], node[+scene.s.complex.neighbor(f.tet, f.corner)]};
}

/// [Edmonds, Karp 1972] over an edge list; node 0 is the outside, node n the inside.
class Flow {
 public:
  Flow(const Scene& scene, const Costs& costs) : n_(costs.bias.size()), arcs_at_(n_ + 1) {
    for (std::uint32_t k = 0; k < costs.facet.size(); ++k) {
      const auto [a, b] = sides(scene, k);
      if (a != b) join(a, b, costs.facet[k], costs.facet[k]);
    }
    for (std::size_t x = 1; x < n_; ++x) {
      join(x, n_, std::max<Capacity>(costs.bias[x], 0), 0);
      join(0, x, std::max<Capacity>(-costs.bias[x], 0), 0);
    }
    while (search()) value_ += augment();
  }

  Capacity value() const { return value_; }
  /// Not reachable from outside in the residual graph.
  bool inside(std::size_t x) const { return x != 0 && arrived_by_[x] == kNone; }

 private:
  struct Arc {
    std::size_t from, to;
    Capacity residual;
  };
  static constexpr std::size_t kNone = SIZE_MAX;

  /// Arcs come in pairs: k and k ^ 1 are opposite.
  void join(std::size_t a, std::size_t b, Capacity there, Capacity back) {
    arcs_at_[a].push_back(arcs_.size());
    arcs_.push_back({a, b, there});
    arcs_at_[b].push_back(arcs_.size());
    arcs_.push_back({b, a, back});
  }

  /// Breadth first from outside; true if it arrives inside.
  bool search() {
    arrived_by_.assign(n_ + 1, kNone);
    std::deque<std::size_t> queue{0};
    while (!queue.empty()) {
      for (const std::size_t k : arcs_at_[queue.front()]) {
        const std::size_t to = arcs_[k].to;
        if (arcs_[k].residual == 0 || to == 0 || arrived_by_[to] != kNone) continue;
        arrived_by_[to] = k;
        queue.push_back(to);
      }
      queue.pop_front();
    }
    return arrived_by_[n_] != kNone;
  }

  template <class Visit>
  void for_path(Visit&& visit) {
    for (std::size_t x = n_; x != 0; x = arcs_[arrived_by_[x]].from) visit(arrived_by_[x]);
  }

  Capacity augment() {
    Capacity flow = INT64_MAX;
    for_path([&](std::size_t k) { flow = std::min(flow, arcs_[k].residual); });
    for_path([&](std::size_t k) {
      arcs_[k].residual -= flow;
      arcs_[k ^ 1].residual += flow;
    });
    return flow;
  }

  std::size_t n_;
  std::vector<Arc> arcs_;
  std::vector<std::vector<std::size_t>> arcs_at_;
  std::vector<std::size_t> arrived_by_;
  Capacity value_ = 0;
};

Capacity cost_of(const Scene& scene, const Costs& costs, const Flags& inside) {
  Capacity sum = 0;
  for (std::uint32_t k = 0; k < costs.facet.size(); ++k) {
    const auto [a, b] = sides(scene, k);
    if (inside[a] != inside[b]) sum += costs.facet[k];
  }
  for (std::size_t x = 1; x < costs.bias.size(); ++x) {
    sum += inside[x] ? std::max<Capacity>(-costs.bias[x], 0) : std::max<Capacity>(costs.bias[x], 0);
  }
  return sum;
}

/// Of one of several kinds, zero and ties likely in some.
Capacity random_capacity(Random& random, std::uint64_t kind) {
  const auto below = [&](std::uint64_t n) { return static_cast<Capacity>(random.bits() % n); };
  switch (kind % 5) {
    case 0:
      return below(3);
    case 1:
      return below(1 << 20);
    case 2:
      return below(4) == 0 ? Capacity{1} << 40 : 0;
    case 3:
      return below(Capacity{1} << 40);
    default:
      return below(2) == 0 ? below(10) : Capacity{1} << below(41);
  }
}

Capacity random_bias(Random& random, std::uint64_t kind) {
  const Capacity bias = random_capacity(random, kind);
  return random.below(2) == 0 ? bias : -bias;
}

Costs random_costs(const Scene& scene, Random& random, std::uint64_t kind) {
  Costs costs;
  for (std::size_t k = 0; k < scene.s.complex.triangle_count(); ++k) {
    costs.facet.push_back(random_capacity(random, kind));
  }
  costs.bias.assign(1, 0);
  while (costs.bias.size() < scene.graph.node_count()) {
    costs.bias.push_back(random_bias(random, kind / 5));
  }
  return costs;
}

MinCut min_cut(const LabelGraph& graph, const Costs& costs) {
  LargeArray<Capacity> capacity;
  for (const LabelGraph::Arc& arc : graph.arcs) capacity.push_back(costs.facet[+arc.triangle]);
  MinCut cut(graph, std::move(capacity));
  for (LabelGraph::Node x = 1; x < costs.bias.size(); ++x) cut.add_inside_bias(x, costs.bias[x]);
  return cut;
}

/// Changes the bias of less than `limit` nodes.
void add_bias(Costs& costs, MinCut& cut, std::size_t limit, Random& random, std::uint64_t kind) {
  for (std::size_t k = random.below(limit); k > 0 && costs.bias.size() > 1; --k) {
    const std::size_t x = 1 + random.below(costs.bias.size() - 1);
    const Capacity bias = random_bias(random, kind);
    costs.bias[x] += bias;
    cut.add_inside_bias(static_cast<LabelGraph::Node>(x), bias);
  }
}

/// Least cost and the smallest outside, which together leave one answer.
void check_cut(const Scene& scene, const Costs& costs, const Flags& inside) {
  const Flow flow(scene, costs);
  REQUIRE(inside.size() == scene.graph.node_count());
  REQUIRE(cost_of(scene, costs, inside) == flow.value());
  for (std::size_t x = 0; x < inside.size(); ++x) REQUIRE((inside[x] != 0) == flow.inside(x));
}

enum class Nodes { kSingle, kOverlaps, kRandom };

/// Every tetrahedron alone, joined where spheres overlap, or joined at random.
Scene scene(const std::vector<Point3>& points, Nodes nodes, std::uint64_t seed) {
  Scene scene{testing::stages(points), {}};
  const TetComplex& complex = scene.s.complex;
  LargeArray<float> overlap = overlaps(complex, Circumspheres(scene.s.points(), complex));
  Random random(seed);
  if (nodes == Nodes::kRandom) {
    const double share = random.uniform(0, 0.5);
    for (float& cosine : overlap) cosine = random.uniform() < share ? 1.0f : 0.0f;
  }
  scene.graph = label_graph(complex, overlap, Flags(complex.tet_count(), nodes == Nodes::kSingle));
  return scene;
}

constexpr Nodes kAllNodes[] = {Nodes::kSingle, Nodes::kOverlaps, Nodes::kRandom};

TEST_CASE("equal to the maximum flow, and again after every change of bias") {
  std::size_t single = 0, merged = 0;
  const std::size_t step = testing::kSanitized ? 4 : 1;
  for (const testing::NamedSet& set : testing::small_sets()) {
    for (std::uint64_t kind = 0; kind < 25; kind += step) {
      const Nodes nodes = kAllNodes[kind % 3];
      INFO(set, ", nodes ", static_cast<int>(nodes), ", capacities ", kind, ", seed ", kind);
      const Scene at = scene(set.points, nodes, kind);
      const std::size_t finite = at.s.complex.finite_tet_count();
      ++(at.graph.node_count() == finite + 1 ? single : merged);
      Random random(kind);
      Costs costs = random_costs(at, random, kind);
      MinCut cut = min_cut(at.graph, costs);
      check_cut(at, costs, cut.solve());
      for (int round = 1; round <= 4; ++round) {
        INFO("round ", round);
        add_bias(costs, cut, 12, random, random.below(5));
        check_cut(at, costs, cut.solve());
      }
    }
  }
  CHECK(single > 300 / step);
  CHECK(merged > 300 / step);
}

TEST_CASE("many rounds: going on is the same as starting anew") {
  for (const Nodes nodes : kAllNodes) {
    const Scene at = scene(point_sets::uniform_cube(700, 1), nodes, 3);
    for (const std::uint64_t kind : {0u, 6u, 12u, 18u, 24u, 9u}) {
      INFO("box of 700, seed 1, nodes ", static_cast<int>(nodes), " of seed 3, capacities ", kind,
           ", seed ", kind);
      Random random(kind);
      Costs costs = random_costs(at, random, kind);
      MinCut cut = min_cut(at.graph, costs);
      for (int round = 0; round < testing::random_cases(20); ++round) {
        INFO("round ", round);
        add_bias(costs, cut, 100, random, kind);
        REQUIRE(cut.solve() == min_cut(at.graph, costs).solve());
      }
    }
  }
}

TEST_CASE("without bias everything is outside; with an overwhelming one nothing is") {
  for (const Nodes nodes : kAllNodes) {
    INFO("box of 100, seed 1, nodes ", static_cast<int>(nodes), " of seed 3");
    const Scene at = scene(point_sets::uniform_cube(100, 1), nodes, 3);
    Random random(1);
    Costs costs = random_costs(at, random, 1);
    std::ranges::fill(costs.bias, 0);
    MinCut cut = min_cut(at.graph, costs);
    const auto count = static_cast<std::ptrdiff_t>(at.graph.node_count());
    REQUIRE(count > 10);
    CHECK(std::ranges::count(cut.solve(), 0) == count);
    for (LabelGraph::Node x = 1; x < at.graph.node_count(); ++x) {
      cut.add_inside_bias(x, Capacity{1} << 40);
    }
    CHECK(std::ranges::count(cut.solve(), 1) == count - 1);
  }
}

TEST_CASE("nothing but outside") {
  const Scene at{{}, {{0}, {1}, {0, 0}, {}}};
  const Flags outside{0};
  CHECK(MinCut(at.graph, {}).solve() == outside);
}

}  // namespace
}  // namespace tetsculpt
