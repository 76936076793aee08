// Predicates under permutations of their arguments: the sign flips or stays as the contracts say.
#include <doctest/doctest.h>

#include <cstdint>
#include <numeric>

#include "kernel/predicates.h"
#include "tests/support/near_degenerate.h"
#include "tests/support/random_cases.h"

namespace tetsculpt {
namespace {

using namespace near_degenerate;

constexpr std::uint64_t kSeed = 2109;
constexpr int kCases = testing::random_cases(50'000);

template <std::size_t kCount>
Points<kCount> equidistant(Rng& rng) {
  if (rng() % 4 == 0) return ragged_sphere<kCount>(rng, rng() % 4 == 0);
  const EqualVectors equal(rng);
  Vectors<kCount> points;
  for (Vector& p : points) p = rng() % 2 == 0 ? equal.on_sphere(rng) : equal.on_circle(rng);
  return mapped<kCount>(rng, points);
}

/// The number of answers that break: predicate(permuted points) == predicate(points) * parity, over
/// all permutations of the first kMoved points; parity counts only if `kAntisymmetric`.
template <std::size_t kMoved, bool kAntisymmetric, std::size_t kCount, class Predicate>
int broken_symmetries(const Points<kCount>& points, const Predicate& predicate) {
  const Sign straight = predicate(points);
  std::array<std::size_t, kMoved> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  int broken = 0;
  do {
    Points<kCount> permuted = points;
    bool odd = false;
    for (std::size_t i = 0; i < kMoved; ++i) {
      permuted[i] = points[order[i]];
      for (std::size_t j = 0; j < i; ++j) odd ^= order[j] > order[i];
    }
    broken += predicate(permuted) != (kAntisymmetric && odd ? -straight : straight);
  } while (std::next_permutation(order.begin(), order.end()));
  return broken;
}

template <std::size_t kMoved, bool kAntisymmetric, std::size_t kCount, class Predicate>
int broken_symmetries_of_many(int cases, const Predicate& predicate) {
  MESSAGE("seed ", kSeed);
  Rng rng(kSeed);
  int broken = 0;
  for (int i = 0; i < cases; ++i) {
    broken += broken_symmetries<kMoved, kAntisymmetric>(hard_case<kCount>(rng, equidistant<kCount>),
                                                        predicate);
  }
  return broken;
}

TEST_CASE("orient3d flips with every swap") {
  CHECK(broken_symmetries_of_many<4, true, 4>(
            kCases, [](const Points<4>& p) { return orient3d(p[0], p[1], p[2], p[3]); }) == 0);
}

TEST_CASE("insphere flips with every swap, of all five") {
  CHECK(broken_symmetries_of_many<5, true, 5>(kCases / 5, [](const Points<5>& p) {
          return insphere(p[0], p[1], p[2], p[3], p[4]);
        }) == 0);
}

TEST_CASE("in_diametral_sphere is symmetric in a and b") {
  CHECK(broken_symmetries_of_many<2, false, 3>(
            kCases, [](const Points<3>& p) { return in_diametral_sphere(p[0], p[1], p[2]); }) == 0);
}

TEST_CASE("in_equatorial_sphere is symmetric in a, b and c") {
  CHECK(broken_symmetries_of_many<3, false, 4>(kCases, [](const Points<4>& p) {
          return in_equatorial_sphere(p[0], p[1], p[2], p[3]);
        }) == 0);
}

TEST_CASE("barycentric_sign is symmetric in b and c") {
  CHECK(broken_symmetries_of_many<2, false, 4>(kCases, [](const Points<4>& p) {
          return barycentric_sign(p[2], p[0], p[1], p[3]);
        }) == 0);
}

TEST_CASE("compare_lengths ignores directions and flips with the edges") {
  CHECK(broken_symmetries_of_many<2, false, 4>(kCases, [](const Points<4>& p) {
          return compare_lengths(p[0], p[1], p[2], p[3]);
        }) == 0);
  CHECK(broken_symmetries_of_many<2, false, 4>(kCases, [](const Points<4>& p) {
          return compare_lengths(p[2], p[3], p[0], p[1]);
        }) == 0);
  CHECK(broken_symmetries_of_many<2, true, 2>(
            kCases, [](const Points<2>& p) { return compare_lengths({}, p[0], {}, p[1]); }) == 0);
}

TEST_CASE("collinear is symmetric") {
  CHECK(broken_symmetries_of_many<3, false, 3>(kCases, [](const Points<3>& p) {
          return collinear(p[0], p[1], p[2]) ? Sign::kZero : Sign::kPositive;
        }) == 0);
}

}  // namespace
}  // namespace tetsculpt
