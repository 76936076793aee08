// Ties and near ties whose differences are integers of every size, from those that fit 128-bit
// arithmetic with room to spare to those that don't: the predicates agree with exact integers.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernel/integer_differences.h"
#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using point_sets::Random;

/// Up to so many bits, either sign, a multiple of a power of two.
double integer(Random& random, int bits, double unit) {
  const double magnitude = std::floor(std::ldexp(random.uniform(), bits));
  return (random.below(2) == 0 ? magnitude : -magnitude) * unit;
}

/// The same three coordinates in any order and with any signs: all such points are on one sphere.
Point3 turned(Random& random, std::array<double, 3> c, const Point3& centre) {
  for (std::size_t i = 3; i > 1; --i) std::swap(c[i - 1], c[random.below(i)]);
  for (double& x : c) x = random.below(2) == 0 ? x : -x;
  return {centre.x + c[0], centre.y + c[1], centre.z + c[2]};
}

TEST_CASE("on one sphere, and one unit off it") {
  exact::Agreement spheres, equators;
  Random random(1);
  for (int bits = 4; bits <= 46; ++bits) {
    for (int round = 0; round < 300; ++round) {
      const double unit = std::ldexp(1.0, static_cast<int>(random.below(120)) - 80);
      const std::array<double, 3> c{integer(random, bits, unit), integer(random, bits, unit),
                                    integer(random, bits, unit)};
      const Point3 centre{integer(random, 5, unit), integer(random, 5, unit), 0};
      std::array<Point3, 5> p;
      for (Point3& q : p) q = turned(random, c, centre);
      if (round % 3 == 0) p[4].x += unit;
      if (exact::orient3d(p[0], p[1], p[2], p[3]) == Sign::kNegative) std::swap(p[0], p[1]);
      spheres.add(exact::insphere(p[0], p[1], p[2], p[3], p[4]),
                  insphere(p[0], p[1], p[2], p[3], p[4]), p);
      if (exact::collinear(p[0], p[1], p[2])) continue;
      equators.add(exact::in_equatorial_sphere(p[0], p[1], p[2], p[3]),
                   in_equatorial_sphere(p[0], p[1], p[2], p[3]), p);
    }
  }
  CHECK_MESSAGE(spheres.failures() == 0, spheres.summary());
  CHECK_MESSAGE(equators.failures() == 0, equators.summary());
  CHECK(spheres.occurrences(Sign::kZero) > 5000);
  CHECK(spheres.occurrences(Sign::kPositive) > 500);
  CHECK(spheres.occurrences(Sign::kNegative) > 500);
}

TEST_CASE("in one plane, and one unit off it") {
  exact::Agreement planes, weights;
  Random random(2);
  for (int bits = 2; bits <= 50; ++bits) {
    for (int round = 0; round < 300; ++round) {
      const double unit = std::ldexp(1.0, static_cast<int>(random.below(120)) - 80);
      const auto vector = [&] {
        return Point3{integer(random, bits, unit), integer(random, bits, unit),
                      integer(random, bits, unit)};
      };
      const Point3 o = vector(), u = vector(), v = vector();
      const auto combination = [&] {
        const double s = static_cast<double>(random.below(3)) - 1;
        const double t = static_cast<double>(random.below(3)) - 1;
        return Point3{o.x + s * u.x + t * v.x, o.y + s * u.y + t * v.y, o.z + s * u.z + t * v.z};
      };
      std::array<Point3, 4> p;
      for (Point3& q : p) q = combination();
      if (round % 3 == 0) p[3].y += unit;
      planes.add(exact::orient3d(p[0], p[1], p[2], p[3]), orient3d(p[0], p[1], p[2], p[3]), p);
      if (exact::collinear(p[0], p[1], p[2])) continue;
      weights.add(exact::barycentric_sign(p[0], p[1], p[2], p[3]),
                  barycentric_sign(p[0], p[1], p[2], p[3]), p);
    }
  }
  CHECK_MESSAGE(planes.failures() == 0, planes.summary());
  CHECK_MESSAGE(weights.failures() == 0, weights.summary());
  CHECK(planes.occurrences(Sign::kZero) > 5000);
  CHECK(planes.occurrences(Sign::kPositive) > 500);
  CHECK(planes.occurrences(Sign::kNegative) > 500);
}

TEST_CASE("differences as integers: exact, in the largest unit, or not at all") {
  const Point3 origin{0.5, 1, -3};
  const Point3 p{0.75, 3, 5}, q{0.5, 1, -3};
  const auto both = integer_differences<2>({&p, &q}, origin, 10);
  REQUIRE(both);
  CHECK(((*both)[0].x == 1 && (*both)[0].y == 8 && (*both)[0].z == 32));
  CHECK(((*both)[1].x == 0 && (*both)[1].y == 0 && (*both)[1].z == 0));
  CHECK(integer_differences<1>({&p}, origin, 6));  // 32 has six bits
  CHECK_FALSE(integer_differences<1>({&p}, origin, 5));
  CHECK(integer_differences<1>({&q}, origin, 1));  // all zero
  const Point3 tiny{0x1p-60, 0, 0};
  CHECK_FALSE(integer_differences<1>({&tiny}, origin, 128));  // the difference is rounded
  CHECK(most_bits(3) == 39);
  CHECK(most_bits(5) == 23);
  CHECK(most_bits(6) == 19);
}

}  // namespace
}  // namespace tetsculpt
