// Keys against their definitions, on tetrahedra whose numbers are known.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <tuple>
#include <vector>

#include "sculpt/priority.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

const double kRoot2 = std::sqrt(2.0);
const double kRoot3 = std::sqrt(3.0);
const double kRoot6 = std::sqrt(6.0);

/// One tetrahedron, whose faces are named by the point opposite, in the order given.
struct OneTet {
  explicit OneTet(std::vector<Point3> corners)
      : input(std::move(corners)), stages(testing::stages(input)) {
    REQUIRE(stages.complex.finite_tet_count() == 1);
  }

  double key(Criterion criterion, std::initializer_list<std::size_t> faces_opposite) const {
    Exposure e;
    for (const std::size_t i : faces_opposite) {
      const VertexId v = stages.distinct.vertex_of_input[i];
      e.facets = static_cast<std::uint8_t>(e.facets |
                                           1u << corner_of(stages.complex.vertices(TetId{0}), v));
      ++e.faces;
    }
    const ManifoldSolid solid = stages.solid();
    return Priority(criterion, stages.points(), solid).key(TetId{0}, e);
  }

  std::vector<Point3> input;
  testing::Stages stages;
};

const OneTet& regular() {
  static const OneTet tet({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  return tet;
}

/// The corner of a cube: the face opposite point 0 is slanted, the circumcentre lies beyond it.
const OneTet& cube_corner() {
  static const OneTet tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  return tet;
}

TEST_CASE("change of area: new faces less those that go, absolute") {
  const double face = 2 * kRoot3;  // edge sqrt(8)
  for (const std::size_t i : {0u, 1u, 2u, 3u}) {
    CHECK(regular().key(Criterion::kMinimalArea, {i}) == doctest::Approx(2 * face));
    CHECK(regular().key(Criterion::kMinimalArea, {i, (i + 1) % 4}) == doctest::Approx(0));
  }
  const double slanted = kRoot3 / 2;
  CHECK(cube_corner().key(Criterion::kMinimalArea, {0}) == doctest::Approx(1.5 - slanted));
  CHECK(cube_corner().key(Criterion::kMinimalArea, {1}) == doctest::Approx(0.5 + slanted));
  CHECK(cube_corner().key(Criterion::kMinimalArea, {0, 1}) == doctest::Approx(slanted - 0.5));
  CHECK(cube_corner().key(Criterion::kMinimalArea, {1, 2}) == doctest::Approx(slanted - 0.5));
}

TEST_CASE("gamma: 1 - r / R, negative where the circumcentre is on the outer side") {
  const double flat = 1 - 2 * kRoot2 / 3;  // r = edge / sqrt(3), R = edge sqrt(6) / 4
  for (const std::size_t i : {0u, 1u, 2u, 3u}) {
    CHECK(regular().key(Criterion::kGamma, {i}) == doctest::Approx(flat));
    CHECK(regular().key(Criterion::kGamma, {i, (i + 1) % 4}) == doctest::Approx(flat));
  }
  // R = sqrt(3) / 2; the slanted face has r = sqrt(2/3), the others sqrt(2) / 2.
  CHECK(cube_corner().key(Criterion::kGamma, {0}) == doctest::Approx(2 * kRoot2 / 3 - 1));
  for (const std::size_t i : {1u, 2u, 3u}) {
    CHECK(cube_corner().key(Criterion::kGamma, {i}) == doctest::Approx(1 - kRoot6 / 3));
  }
}

TEST_CASE("gamma of two faces is the smaller one") {
  CHECK(cube_corner().key(Criterion::kGamma, {0, 2}) == doctest::Approx(2 * kRoot2 / 3 - 1));
  CHECK(cube_corner().key(Criterion::kGamma, {1, 2}) == doctest::Approx(1 - kRoot6 / 3));
}

TEST_CASE("the longest edge on the boundary faces counts, no other") {
  // Squared lengths: 01: 1, 02: 4, 12: 5, 03: 9, 13: 10, 23: 13; ranks 0 to 5 in this order.
  const OneTet tet({{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}});
  for (const Criterion criterion : {Criterion::kLongestEdge, Criterion::kConstrained}) {
    CHECK(tet.key(criterion, {0}) == -5);  // edges 12, 13, 23
    CHECK(tet.key(criterion, {1}) == -5);  // 02, 03, 23
    CHECK(tet.key(criterion, {2}) == -4);  // 01, 03, 13
    CHECK(tet.key(criterion, {3}) == -2);  // 01, 02, 12
    CHECK(tet.key(criterion, {2, 3}) == -4);
    CHECK(tet.key(criterion, {1, 3}) == -5);
  }
}

TEST_CASE("ranks follow exact length, then the end points") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    if (!set.name.starts_with("lattice") && !set.name.starts_with("grid")) continue;
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const auto order_of = [&](TetId t, int k) {
      const auto& [a, b] = s.complex.vertices(s.complex.edge(t, k));
      const Point3 &p = s.points()[+a], &q = s.points()[+b];
      const double dx = p.x - q.x, dy = p.y - q.y, dz = p.z - q.z;
      return std::tuple(dx * dx + dy * dy + dz * dz, a, b);  // exact: small integers
    };
    // One face after the other, all tetrahedra: the rank grows with the longest edge.
    std::vector<std::pair<decltype(order_of(TetId{}, 0)), std::uint32_t>> longest;
    const ManifoldSolid solid = s.solid();
    for (const TetId t : s.tets()) {
      for (std::size_t face = 0; face < 4; ++face) {
        const auto& [i, j, k] = kFacetCorners[face];
        longest.emplace_back(
            std::max({order_of(t, kEdgeOfCorners[i][j]), order_of(t, kEdgeOfCorners[j][k]),
                      order_of(t, kEdgeOfCorners[i][k])}),
            solid.longest_rank(t, 1u << face));
      }
    }
    std::sort(longest.begin(), longest.end());
    for (std::size_t i = 1; i < longest.size(); ++i) {
      const auto& [before, low] = longest[i - 1];
      const auto& [after, high] = longest[i];
      REQUIRE((before < after ? low < high : low == high));
    }
  }
}

}  // namespace
}  // namespace tetsculpt
