// The boundary of a set of tetrahedra is a 2-manifold exactly if all stars are good.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/triangle_mesh.h"
#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

/// Counts for how many labels the theorem was seen at work, either way.
class Theorem {
 public:
  explicit Theorem(const testing::Stages& s) : s_(s), stars_(s.complex) {}

  void check(const Flags& inside) {
    const Topology t = topology(s_.surface(inside));
    const bool good = s_.all_stars_good(stars_, inside);
    REQUIRE(good == (t.edge_manifold && t.vertex_manifold));
    REQUIRE(t.oriented == t.edge_manifold);
    if (good) REQUIRE(t.closed == (std::ranges::count(inside, 1) > 0));
    ++(good ? manifolds_ : others_);
  }
  int manifolds() const { return manifolds_; }
  int others() const { return others_; }

 private:
  const testing::Stages& s_;
  VertexStars stars_;
  int manifolds_ = 0;
  int others_ = 0;
};

TEST_CASE("random labels, from none to all") {
  int manifolds = 0, others = 0;
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    Theorem theorem(s);
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      INFO(set, ", labels of seed ", seed);
      point_sets::Random random(seed);
      const double share = random.uniform(-0.1, 1.1);
      Flags inside(s.complex.tet_count(), 0);
      for (const TetId t : s.tets()) inside[+t] = random.uniform() < share;
      theorem.check(inside);
    }
    manifolds += theorem.manifolds();
    others += theorem.others();
  }
  CHECK(manifolds > 100);
  CHECK(others > 100);
}

TEST_CASE("one tetrahedron after the other, from none to all") {
  int manifolds = 0, others = 0;
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set, ", order of seed 1");
    const testing::Stages s = testing::stages(set.points);
    Theorem theorem(s);
    point_sets::Random random(1);
    std::vector<TetId> order = s.tets();
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    Flags inside(s.complex.tet_count(), 0);
    for (const TetId t : order) {
      inside[+t] = 1;
      theorem.check(inside);
    }
    manifolds += theorem.manifolds();
    others += theorem.others();
  }
  CHECK(manifolds > 100);
  CHECK(others > 100);
}

/// No hull vertex among its corners.
bool interior(const testing::Stages& s, const VertexStars& stars, TetId t) {
  return std::ranges::all_of(s.complex.vertices(t), [&](VertexId v) {
    return std::ranges::all_of(stars(v), [&](TetId u) { return s.complex.finite(u); });
  });
}

/// Two tetrahedra with just so many corners in common, and nothing else inside; or inside out.
Flags touching_pair(const testing::Stages& s, const VertexStars& stars, std::ptrdiff_t common,
                    bool inside_out) {
  Flags inside(s.complex.tet_count(), 0);
  for (const TetId t : s.tets()) inside[+t] = inside_out;
  for (const TetId a : s.tets()) {
    if (!interior(s, stars, a)) continue;
    const auto in_a = [&](VertexId v) { return std::ranges::count(s.complex.vertices(a), v) > 0; };
    for (const TetId b : s.tets()) {
      const auto& corners = s.complex.vertices(b);
      if (std::ranges::count_if(corners, in_a) != common || !interior(s, stars, b)) continue;
      inside[+a] = inside[+b] = !inside_out;
      return inside;
    }
  }
  return {};
}

TEST_CASE("two tetrahedra that touch in a vertex, an edge or a facet") {
  const testing::Stages s = testing::stages(point_sets::uniform_cube(100, 1));
  const VertexStars stars(s.complex);
  for (const bool inside_out : {false, true}) {
    for (const int common : {1, 2, 3}) {
      INFO("box of 100, seed 1, corners in common ", common, ", inside out ", inside_out);
      const Flags inside = touching_pair(s, stars, common, inside_out);
      REQUIRE_FALSE(inside.empty());
      const Topology t = topology(s.surface(inside));
      CHECK(t.edge_manifold == (common != 2));
      CHECK((t.edge_manifold && t.vertex_manifold) == (common == 3));
      CHECK(s.all_stars_good(stars, inside) == (common == 3));
    }
  }
}

}  // namespace
}  // namespace tetsculpt
