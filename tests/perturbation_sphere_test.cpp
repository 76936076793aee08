// in_perturbed_sphere and its tie rule agree with the oracle, on all ties of small lattices and
// beyond.
#include <doctest/doctest.h>

#include <cstdint>
#include <map>
#include <vector>

#include "kernel/perturbation.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2110;
constexpr int kCases = testing::random_cases(1'000'000);

Sign as_sign(bool inside) { return inside ? Sign::kPositive : Sign::kNegative; }

/// Compares many cases, and counts which point decided ties.
struct Comparison {
  exact::Agreement agreement;
  std::int64_t tie_count = 0;
  /// Per rank, argument and answer.
  std::array<std::array<std::array<std::int64_t, 2>, 5>, 5> ties{};

  void add(Points<5> points) {
    auto& [a, b, c, d, e] = points;
    const Sign orientation = exact::orient3d(a, b, c, d);
    if (orientation == Sign::kZero) return;
    if (orientation == Sign::kNegative) std::swap(a, b);
    const exact::PerturbedSide expected = exact::in_perturbed_sphere(a, b, c, d, e);
    agreement.add(as_sign(expected.inside), as_sign(in_perturbed_sphere(a, b, c, d, e)), points);
    if (expected.rank < 0) return;
    agreement.add(as_sign(expected.inside), as_sign(perturbed_inside(a, b, c, d, e)), points);
    ++tie_count;
    ++ties[static_cast<std::size_t>(expected.rank)][expected.argument][expected.inside];
  }

  /// The greatest point, or the next one if e projects on the face opposite to it. Never a third:
  /// with two zeros, e would be on the line through two corners, and thus one of them.
  void check_that_every_branch_occurred() const {
    for (std::size_t rank = 0; rank < 5; ++rank) {
      for (std::size_t argument = 0; argument < 5; ++argument) {
        const auto [outside, inside] = ties[rank][argument];
        CHECK((outside > 0) == (rank < 2));
        CHECK((inside > 0) == (rank < 2 && argument < 4));
      }
    }
  }
};

bool distinct(const Points<5>& points) {
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (points[i] == points[j]) return false;
    }
  }
  return true;
}

/// The spheres with at least five points of {0..3}^3 whose centres are multiples of 1/2 in the
/// cube.
std::vector<std::vector<Point3>> lattice_spheres() {
  std::vector<std::vector<Point3>> spheres;
  for (int centre = 0; centre < 7 * 7 * 7; ++centre) {
    std::map<double, std::vector<Point3>> by_distance;
    for (int i = 0; i < 64; ++i) {
      const Point3 p{double(i / 16), double(i / 4 % 4), double(i % 4)};
      const double x = p.x - 0.5 * (centre / 49), y = p.y - 0.5 * (centre / 7 % 7),
                   z = p.z - 0.5 * (centre % 7);
      by_distance[x * x + y * y + z * z].push_back(p);
    }
    for (auto& [distance, points] : by_distance) {
      if (points.size() >= 5) spheres.push_back(std::move(points));
    }
  }
  return spheres;
}

TEST_CASE("five points of one sphere of a lattice") {
  const std::vector<std::vector<Point3>> spheres = lattice_spheres();
  Rng rng(kSeed);
  Comparison comparison;
  while (comparison.tie_count < kCases) {
    std::vector<Point3> sphere = spheres[rng() % spheres.size()];
    for (std::size_t j = 0; j < 5; ++j) {
      std::swap(sphere[j], sphere[j + rng() % (sphere.size() - j)]);
    }
    comparison.add({sphere[0], sphere[1], sphere[2], sphere[3], sphere[4]});
  }
  MESSAGE("seed ", kSeed, ": ", "ties ", comparison.tie_count, ", ",
          comparison.agreement.summary());
  CHECK(comparison.agreement.failures() == 0);
  comparison.check_that_every_branch_occurred();
}

TEST_CASE("all ordered tetrahedra of the cube's corners, against the other corners") {
  Comparison comparison;
  const auto corner = [](unsigned i) {
    return Point3{double(i & 1), double(i >> 1 & 1), double(i >> 2)};
  };
  for (unsigned code = 0; code < 1U << 15; ++code) {
    const Points<5> points{corner(code & 7), corner(code >> 3 & 7), corner(code >> 6 & 7),
                           corner(code >> 9 & 7), corner(code >> 12)};
    if (distinct(points)) comparison.add(points);
  }
  CHECK(comparison.agreement.failures() == 0);
  comparison.check_that_every_branch_occurred();
}

TEST_CASE("rotated, moved and nudged spheres") {
  Rng rng(kSeed + 1);
  Comparison comparison;
  for (int i = 0; i < kCases; ++i) {
    const Points<5> points = hard_case<5>(rng, [](Rng& r) {
      if (r() % 4 == 0) return ragged_sphere<5>(r, false);
      const EqualVectors equal(r);
      Vectors<5> on_sphere;
      for (Vector& p : on_sphere) p = r() % 4 == 0 ? equal.on_circle(r) : equal.on_sphere(r);
      return mapped<5>(r, on_sphere);
    });
    if (distinct(points)) comparison.add(points);
  }
  MESSAGE("seed ", kSeed + 1, ": ", comparison.agreement.summary());
  CHECK(comparison.agreement.failures() == 0);
  comparison.check_that_every_branch_occurred();
}

}  // namespace
}  // namespace tetsculpt
