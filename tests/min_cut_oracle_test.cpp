// The minimum cut against a maximum flow found the plain way, by shortest augmenting paths.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "kernel/tet_complex.h"
#include "sculpt/min_cut.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using Capacity = MinCut::Capacity;
using point_sets::Random;

/// Costs of a cut.
struct Costs {
  std::vector<Capacity> facet;  ///< per triangle
  std::vector<Capacity> bias;   ///< per finite tetrahedron, towards inside
};

/// [Edmonds, Karp 1972] over an edge list; node n is the outside, n + 1 the inside.
class Flow {
 public:
  Flow(const TetComplex& complex, const Costs& costs)
      : n_(complex.finite_tet_count()), arcs_at_(n_ + 2) {
    const auto node = [&](TetId t) { return complex.finite(t) ? +t : n_; };
    for (std::uint32_t k = 0; k < complex.triangle_count(); ++k) {
      const Facet f = complex.facet(TriangleId{k});
      join(+f.tet, node(complex.neighbor(f.tet, f.corner)), costs.facet[k], costs.facet[k]);
    }
    for (std::size_t t = 0; t < n_; ++t) {
      join(t, n_ + 1, std::max<Capacity>(costs.bias[t], 0), 0);
      join(n_, t, std::max<Capacity>(-costs.bias[t], 0), 0);
    }
    while (search()) value_ += augment();
  }

  Capacity value() const { return value_; }
  /// Not reachable from outside in the residual graph.
  bool inside(std::size_t t) const { return arrived_by_[t] == kNone; }

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
    arrived_by_.assign(n_ + 2, kNone);
    std::deque<std::size_t> queue{n_};
    while (!queue.empty()) {
      for (const std::size_t k : arcs_at_[queue.front()]) {
        const std::size_t to = arcs_[k].to;
        if (arcs_[k].residual == 0 || to == n_ || arrived_by_[to] != kNone) continue;
        arrived_by_[to] = k;
        queue.push_back(to);
      }
      queue.pop_front();
    }
    return arrived_by_[n_ + 1] != kNone;
  }

  template <class Visit>
  void for_path(Visit&& visit) {
    for (std::size_t x = n_ + 1; x != n_; x = arcs_[arrived_by_[x]].from) visit(arrived_by_[x]);
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

Capacity cost_of(const TetComplex& complex, const Costs& costs, const Flags& inside) {
  Capacity sum = 0;
  for (std::uint32_t k = 0; k < complex.triangle_count(); ++k) {
    const Facet f = complex.facet(TriangleId{k});
    if (inside[+f.tet] != inside[+complex.neighbor(f.tet, f.corner)]) sum += costs.facet[k];
  }
  for (std::size_t t = 0; t < costs.bias.size(); ++t) {
    sum += inside[t] ? std::max<Capacity>(-costs.bias[t], 0) : std::max<Capacity>(costs.bias[t], 0);
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

Costs random_costs(const TetComplex& complex, Random& random, std::uint64_t kind) {
  Costs costs;
  for (std::size_t k = 0; k < complex.triangle_count(); ++k) {
    costs.facet.push_back(random_capacity(random, kind));
  }
  for (std::size_t t = 0; t < complex.finite_tet_count(); ++t) {
    costs.bias.push_back(random_bias(random, kind / 5));
  }
  return costs;
}

MinCut min_cut(const TetComplex& complex, const Costs& costs) {
  MinCut cut(complex);
  for (std::uint32_t k = 0; k < complex.triangle_count(); ++k) {
    cut.set_facet(TriangleId{k}, costs.facet[k]);
  }
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    cut.add_inside_bias(TetId{t}, costs.bias[t]);
  }
  return cut;
}

/// Least cost and the smallest outside, which together leave one answer.
void check_cut(const TetComplex& complex, const Costs& costs, const Flags& inside) {
  const Flow flow(complex, costs);
  REQUIRE(inside.size() == complex.tet_count());
  REQUIRE(cost_of(complex, costs, inside) == flow.value());
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    REQUIRE((inside[t] != 0) == (complex.finite(TetId{t}) && flow.inside(t)));
  }
}

TEST_CASE("equal to the maximum flow, and again after every change of bias") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    for (std::uint64_t kind = 0; kind < 25; ++kind) {
      INFO(set, ", capacities ", kind, ", seed ", kind);
      Random random(kind);
      Costs costs = random_costs(s.complex, random, kind);
      MinCut cut = min_cut(s.complex, costs);
      check_cut(s.complex, costs, cut.solve());
      for (int round = 1; round <= 4; ++round) {
        INFO("round ", round);
        for (std::size_t k = random.below(12); k > 0; --k) {
          const std::size_t t = random.below(costs.bias.size());
          const Capacity bias = random_bias(random, random.below(5));
          costs.bias[t] += bias;
          cut.add_inside_bias(TetId{static_cast<std::uint32_t>(t)}, bias);
        }
        check_cut(s.complex, costs, cut.solve());
      }
    }
  }
}

TEST_CASE("many rounds: going on is the same as starting anew") {
  const testing::Stages s = testing::stages(point_sets::uniform_cube(1000, 1));
  for (const std::uint64_t kind : {0u, 6u, 12u, 18u, 24u, 9u}) {
    INFO("box of 1000, seed 1, capacities ", kind, ", seed ", kind);
    Random random(kind);
    Costs costs = random_costs(s.complex, random, kind);
    MinCut cut = min_cut(s.complex, costs);
    for (int round = 0; round < 40; ++round) {
      INFO("round ", round);
      for (std::size_t k = random.below(100); k > 0; --k) {
        const std::size_t t = random.below(costs.bias.size());
        const Capacity bias = random_bias(random, kind);
        costs.bias[t] += bias;
        cut.add_inside_bias(TetId{static_cast<std::uint32_t>(t)}, bias);
      }
      REQUIRE(cut.solve() == min_cut(s.complex, costs).solve());
    }
  }
}

TEST_CASE("without bias everything is outside; with an overwhelming one nothing is") {
  const testing::Stages s = testing::stages(point_sets::uniform_cube(100, 1));
  Random random(1);
  Costs costs = random_costs(s.complex, random, 1);
  std::ranges::fill(costs.bias, 0);
  MinCut cut = min_cut(s.complex, costs);
  CHECK(std::ranges::count(cut.solve(), 0) == static_cast<long>(s.complex.tet_count()));
  for (const TetId t : s.tets()) cut.add_inside_bias(t, Capacity{1} << 40);
  CHECK(std::ranges::count(cut.solve(), 1) == static_cast<long>(s.complex.finite_tet_count()));
}

}  // namespace
}  // namespace tetsculpt
