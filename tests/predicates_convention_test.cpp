// The signs that the contracts promise, on cases worked out by hand; predicates and oracles alike.
#include <doctest/doctest.h>

#include "kernel/perturbation.h"
#include "kernel/predicates.h"
#include "tests/support/exact_predicates.h"

namespace tetsculpt {
namespace {

constexpr Point3 kOrigin{0, 0, 0};
constexpr Point3 kX{2, 0, 0};
constexpr Point3 kY{0, 2, 0};
constexpr Point3 kZ{0, 0, 2};

TEST_CASE("orient3d is positive below a triangle that looks counterclockwise from above") {
  CHECK(orient3d(kOrigin, kX, kY, {0, 0, -1}) == Sign::kPositive);
  CHECK(exact::orient3d(kOrigin, kX, kY, {0, 0, -1}) == Sign::kPositive);
  CHECK(orient3d(kOrigin, kX, kY, kZ) == Sign::kNegative);
  CHECK(exact::orient3d(kOrigin, kX, kY, kZ) == Sign::kNegative);
  CHECK(orient3d(kOrigin, kX, kY, {7, -3, 0}) == Sign::kZero);
}

TEST_CASE("insphere is positive inside a positive tetrahedron's sphere") {
  // The sphere of these four has the centre (1, 1, 1) and passes through (2, 2, 2).
  CHECK(insphere(kX, kOrigin, kY, kZ, {1, 1, 1}) == Sign::kPositive);
  CHECK(exact::insphere(kX, kOrigin, kY, kZ, {1, 1, 1}) == Sign::kPositive);
  CHECK(insphere(kX, kOrigin, kY, kZ, {3, 1, 1}) == Sign::kNegative);
  CHECK(exact::insphere(kX, kOrigin, kY, kZ, {3, 1, 1}) == Sign::kNegative);
  CHECK(insphere(kX, kOrigin, kY, kZ, {2, 2, 2}) == Sign::kZero);
  CHECK(insphere(kOrigin, kX, kY, kZ, {1, 1, 1}) == Sign::kNegative);
  CHECK(insphere(kOrigin, kX, kY, {2, 2, 0}, {5, 1, 0}) == Sign::kZero);
}

TEST_CASE("the smallest spheres of an edge and of a triangle") {
  CHECK(in_diametral_sphere(kOrigin, kX, {1, 0.5, 0.5}) == Sign::kPositive);
  CHECK(in_diametral_sphere(kOrigin, kX, {1, 0, -1}) == Sign::kZero);
  CHECK(in_diametral_sphere(kOrigin, kX, {2.5, 0, 0}) == Sign::kNegative);
  // Right angle at the origin: centre (1, 1, 0), squared radius 2.
  CHECK(in_equatorial_sphere(kOrigin, kX, kY, {1, 1, 1}) == Sign::kPositive);
  CHECK(exact::in_equatorial_sphere(kOrigin, kX, kY, {1, 1, 1}) == Sign::kPositive);
  CHECK(in_equatorial_sphere(kOrigin, kX, kY, {2, 1, 1}) == Sign::kZero);
  CHECK(in_equatorial_sphere(kOrigin, kX, kY, {2, 2, 1}) == Sign::kNegative);
  CHECK(in_equatorial_sphere(kOrigin, {1, 1, 1}, {2, 2, 2}, kX) == Sign::kZero);
}

TEST_CASE("barycentric_sign belongs to the first argument and projects p") {
  CHECK(barycentric_sign(kOrigin, kX, kY, {0.5, 0.5, 9}) == Sign::kPositive);
  CHECK(exact::barycentric_sign(kOrigin, kX, kY, {0.5, 0.5, 9}) == Sign::kPositive);
  CHECK(barycentric_sign(kOrigin, kX, kY, {1.5, 0.5, 9}) == Sign::kZero);
  CHECK(barycentric_sign(kOrigin, kX, kY, {2, 2, -9}) == Sign::kNegative);
  CHECK(barycentric_sign(kX, kOrigin, kY, {-1, 0, 0}) == Sign::kNegative);
}

TEST_CASE("lengths and lines") {
  CHECK(compare_lengths(kOrigin, kX, kY, {0, 2, 1}) == Sign::kPositive);
  CHECK(compare_lengths(kOrigin, kX, kOrigin, kY) == Sign::kZero);
  CHECK(compare_lengths(kX, kX, kOrigin, kY) == Sign::kNegative);
  CHECK(collinear(kOrigin, {1, 2, 3}, {-2, -4, -6}));
  CHECK(collinear(kX, kX, kY));
  CHECK_FALSE(collinear(kOrigin, kX, kY));
}

TEST_CASE("ties: the greater point's eps decides, and a lifted point is outside") {
  // All on the sphere about (1, 1, 1); {2, 2, 2} is the greatest of the five.
  CHECK_FALSE(in_perturbed_sphere(kX, kOrigin, kY, kZ, {2, 2, 2}));
  CHECK_FALSE(exact::in_perturbed_sphere(kX, kOrigin, kY, kZ, {2, 2, 2}).inside);
  // {2, 2, 0} = kX + kY - origin: here the greatest corner is kX, with a positive coordinate, but
  // the point itself is greater; mirrored at x = 1 it isn't: {0, 2, 2} = kY + kZ - origin, and the
  // greatest corner kX has the coordinate 0, so that {0, 2, 2} itself is the next and decides.
  CHECK_FALSE(in_perturbed_sphere(kX, kOrigin, kY, kZ, {2, 2, 0}));
  CHECK_FALSE(in_perturbed_sphere(kX, kOrigin, kY, kZ, {0, 2, 2}));
  // The origin is the least; seen from the other corners, kX + kY - {2, 2, 0}: {2, 2, 0} decides
  // with a negative coordinate, outside. Against {2, 2, 2}, {0, 2, 0}, {2, 0, 0}, {0, 0, 2}, whose
  // coordinates are -1/2, 1/2, 1/2, 1/2, it is outside too, and with {2, 2, 2} for it, {2, 0, 2}
  // inside.
  CHECK_FALSE(exact::in_perturbed_sphere(kX, {2, 2, 0}, kZ, kY, kOrigin).inside);
  CHECK_FALSE(in_perturbed_sphere(kX, {2, 2, 0}, kZ, kY, kOrigin));
  CHECK_FALSE(in_perturbed_diametral_sphere(kOrigin, kY, {1, 1, 0}));
  CHECK(in_perturbed_diametral_sphere(kOrigin, {2, 2, 0}, kX));
  // p = {2, 1, 1} is greater than all three corners; p = {0, 1, 1} isn't, and kX decides: its
  // coordinate is 0, so that kY, with 1/2, puts p inside.
  CHECK_FALSE(in_perturbed_equatorial_sphere(kOrigin, kX, kY, {2, 1, 1}));
  CHECK(in_perturbed_equatorial_sphere(kOrigin, kX, kY, {0, 1, 1}));
}

}  // namespace
}  // namespace tetsculpt
