// Circumspheres against what defines them, as closely as rounding allows.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sculpt/circumspheres.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using Vec = Vec3<double>;

std::vector<testing::NamedSet> all_sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  // Points of a plane, moved off it by an ulp or so: flat tetrahedra.
  std::vector<Point3> plane = point_sets::grid(5);
  point_sets::Random random(1);
  for (Point3& p : plane) p.z = 1 + static_cast<double>(random.below(3)) * 0x1p-52;
  sets.push_back({"nearly flat, seed 1", plane});
  sets.push_back({"box far off, seed 1",
                  point_sets::translated(point_sets::uniform_cube(60, 1), {1e6, -1e6, 1e6})});
  return sets;
}

/// A bound on the error of a centre. It is a quotient: the numerator's terms are below
/// 6 extent^4, the denominator's below 12 extent^3, each with a few roundings.
double error_bound(const testing::Stages& s, TetId t, double radius) {
  const auto& v = s.complex.vertices(t);
  const Vec a = from_to(s.points()[+v[0]], s.points()[+v[1]]);
  const Vec b = from_to(s.points()[+v[0]], s.points()[+v[2]]);
  const Vec c = from_to(s.points()[+v[0]], s.points()[+v[3]]);
  const double extent = length(a) + length(b) + length(c);
  const double volume = std::fabs(dot(a, cross(b, c)));
  const double place = length(as_vector(s.points()[+v[0]]));
  return 0x1p-48 * ((extent + radius) * extent * extent * extent / volume + place + radius);
}

TEST_CASE("centres are equally far from all corners") {
  std::size_t sharp = 0, all = 0;
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const Circumspheres spheres(s.points(), s.complex);
    for (const TetId t : s.tets()) {
      INFO(set, ", tetrahedron ", +t);
      const double radius = spheres.radius(t);
      REQUIRE(radius > 0);  // not NaN either
      ++all;
      const double error = std::isfinite(radius) ? error_bound(s, t, radius) : HUGE_VAL;
      if (!(error < radius)) continue;
      for (const VertexId v : s.complex.vertices(t)) {
        const double distance = length(from_to(as_vector(s.points()[+v]), spheres.centre(t)));
        REQUIRE(std::fabs(distance - radius) <= error);
      }
      sharp += error < 1e-9 * radius;
    }
  }
  MESSAGE(sharp, " of ", all, " centres to nine digits");
  CHECK(10 * sharp > 9 * all);
}

TEST_CASE("the centre of a lattice sphere") {
  for (const long squared_radius : {3L, 9L, 14L, 101L}) {
    INFO("squared radius ", squared_radius);
    const auto points =
        point_sets::translated(point_sets::lattice_sphere(squared_radius), {1, 2, 3});
    const testing::Stages s = testing::stages(points);
    const Circumspheres spheres(s.points(), s.complex);
    for (const TetId t : s.tets()) {
      REQUIRE(spheres.centre(t).x == doctest::Approx(1).epsilon(1e-12));
      REQUIRE(spheres.centre(t).y == doctest::Approx(2).epsilon(1e-12));
      REQUIRE(spheres.centre(t).z == doctest::Approx(3).epsilon(1e-12));
      REQUIRE(spheres.radius(t) * spheres.radius(t) ==
              doctest::Approx(static_cast<double>(squared_radius)));
      for (int i = 0; i < 4; ++i) {
        if (s.complex.finite(s.complex.neighbor(t, i))) {
          REQUIRE(spheres.overlap(t, i) == doctest::Approx(1));
        }
      }
    }
  }
}

using Triangle = std::array<Point3, 3>;

/// The hull triangle of an infinite tetrahedron.
Triangle hull_triangle(const testing::Stages& s, TetId infinite) {
  Triangle triangle;
  std::size_t n = 0;
  for (const VertexId v : s.complex.vertices(infinite)) {
    if (v != kInfinite) triangle[n++] = s.points()[+v];
  }
  return triangle;
}

/// How far a triangle's normal may be off: its terms lose digits where two edges nearly align.
double normal_error(const Triangle& t) {
  const Vec u = from_to(t[0], t[1]), v = from_to(t[0], t[2]), w = from_to(t[1], t[2]);
  const double longest = std::max({length(u), length(v), length(w)});
  return 0x1p-49 * (1 + longest * longest / length(cross(u, v)));
}

TEST_CASE("outward normals: all points on the other side of the hull triangle") {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const Circumspheres spheres(s.points(), s.complex);
    for (std::size_t t = s.complex.finite_tet_count(); t < s.complex.tet_count(); ++t) {
      INFO(set, ", tetrahedron ", t);
      const TetId outside{static_cast<std::uint32_t>(t)};
      const Triangle hull = hull_triangle(s, outside);
      const Vec outward = spheres.outward(outside);
      REQUIRE(length(outward) == doctest::Approx(1));
      for (const Point3& p : s.points()) {
        const Vec to = from_to(hull[0], p);
        REQUIRE(dot(to, outward) <= normal_error(hull) * length(to));
      }
    }
  }
}

/// A value and how far rounding may have moved it.
struct Estimate {
  double value;
  double error;
};

Estimate overlap_by_formula(const testing::Stages& s, const Circumspheres& spheres, TetId t,
                            int corner) {
  const TetId u = s.complex.neighbor(t, corner);
  if (!s.complex.finite(t) && !s.complex.finite(u)) return {1, 0};  // the same infinite sphere
  if (s.complex.finite(t) && s.complex.finite(u)) {
    const double r = spheres.radius(t), q = spheres.radius(u);
    const double d = length(from_to(spheres.centre(t), spheres.centre(u)));
    return {(r * r + q * q - d * d) / (2 * r * q), 0x1p-48 * (r * r + q * q + d * d) / (r * q)};
  }
  // The limit of that for a sphere that grows to the half-space: the centre's height over radius.
  const TetId finite = s.complex.finite(t) ? t : u;
  const TetId beyond = s.complex.finite(t) ? u : t;
  const Triangle hull = hull_triangle(s, beyond);
  const Vec to_centre = from_to(as_vector(hull[0]), spheres.centre(finite));
  const double radius = spheres.radius(finite);
  const double centre_error = error_bound(s, finite, radius) / radius;
  return {dot(to_centre, spheres.outward(beyond)) / radius, normal_error(hull) + 2 * centre_error};
}

TEST_CASE("overlaps: the same from both sides, in range, and as the formula has it") {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const Circumspheres spheres(s.points(), s.complex);
    for (std::uint32_t t = 0; t < s.complex.tet_count(); ++t) {
      for (int i = 0; i < 4; ++i) {
        INFO(set, ", tetrahedron ", t, ", facet ", i);
        const double overlap = spheres.overlap(TetId{t}, i);
        const Facet other = s.complex.across(TetId{t}, i);
        REQUIRE(std::fabs(overlap) <= 1);
        REQUIRE(spheres.overlap(other.tet, other.corner) == overlap);
        if (std::isinf(spheres.radius(TetId{t})) || std::isinf(spheres.radius(other.tet))) {
          REQUIRE(overlap == 0);
          continue;
        }
        const auto [value, error] = overlap_by_formula(s, spheres, TetId{t}, i);
        REQUIRE(std::fabs(overlap - std::clamp(value, -1.0, 1.0)) <= error);
      }
    }
  }
}

TEST_CASE("spheres do not depend on the numbering of the complex") {
  for (const testing::NamedSet& set : all_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const TetComplex other = testing::renumbered(s.complex, 1);
    const auto numbers_by_corners = [&](const TetComplex& complex) {
      const Circumspheres spheres(s.points(), complex);
      std::map<std::array<VertexId, 4>, std::array<double, 4>> numbers;
      for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
        std::array<VertexId, 4> corners = complex.vertices(TetId{t});
        std::ranges::sort(corners);
        const Vec c = spheres.centre(TetId{t});  // or the outward normal
        const double radius = spheres.radius(TetId{t});
        numbers[corners] = std::isinf(radius) ? std::array{0.0, 0.0, 0.0, radius}
                                              : std::array{c.x, c.y, c.z, radius};
      }
      return numbers;
    };
    INFO(set, ", renumbered by seed 1");
    CHECK((numbers_by_corners(s.complex) == numbers_by_corners(other)));
  }
}

}  // namespace
}  // namespace tetsculpt
