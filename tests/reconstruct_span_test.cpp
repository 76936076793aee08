// Points that span no solid are a normal outcome, with nothing in it but what they span.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

using Points = std::vector<Point3>;

Reconstruction without_surface(const Points& points) {
  Reconstruction result = testing::reconstruct_paper(points);
  CHECK(result.mesh.points.empty());
  CHECK(result.mesh.triangles.empty());
  CHECK(result.hidden.empty());
  return result;
}

TEST_CASE("nothing") { CHECK(without_surface({}).span == Span::kNothing); }

TEST_CASE("one point, once or often") {
  CHECK(without_surface({{1, 2, 3}}).span == Span::kPoint);
  const Reconstruction result = without_surface(Points(9, {1, 2, 3}));
  CHECK(result.span == Span::kPoint);
  CHECK(result.counts.vertices == 1);
  CHECK(without_surface({{0, 0, 0}, {-0.0, 0, 0}, {0, -0.0, -0.0}}).span == Span::kPoint);
}

TEST_CASE("a line") {
  CHECK(without_surface({{0, 0, 0}, {1e-300, 0, 0}}).span == Span::kLine);
  Points line;
  for (int i = 0; i < 50; ++i) line.push_back({i * 3.0, i * -5.0, i * 7.0});
  const Reconstruction result = without_surface(point_sets::shuffled(line, 1));
  CHECK(result.span == Span::kLine);
  CHECK(result.counts.vertices == 50);
}

TEST_CASE("a plane") {
  CHECK(without_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).span == Span::kPlane);
  Points plane = point_sets::plane_and_apex(100, 2);
  plane.pop_back();
  CHECK(without_surface(plane).span == Span::kPlane);
  Points tilted;
  for (int i = 0; i < 64; ++i)
    tilted.push_back({1.0 * (i % 8), 1.0 * (i / 8), i % 8 + 2.0 * (i / 8)});
  CHECK(without_surface(tilted).span == Span::kPlane);
}

TEST_CASE("one ulp off the line or the plane is enough for more") {
  const double up = std::nextafter(1.0, 2.0);
  CHECK(without_surface({{0, 0, 0}, {1, 1, 1}, {2, 2, 2 * up}}).span == Span::kPlane);
  const Points solid{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 2 * up}};
  CHECK(testing::reconstruct_paper(solid).span == Span::kSolid);
}

TEST_CASE("four points in general position: their tetrahedron") {
  const Points corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Reconstruction result = testing::reconstruct_paper(corners);
  CHECK(result.span == Span::kSolid);
  CHECK(result.mesh.points == corners);
  CHECK(result.mesh.triangles.size() == 4);
  CHECK(testing::signed_volume(result.mesh) == doctest::Approx(1.0 / 6));
  CHECK(result.counts.vertices == 4);
  CHECK(result.counts.tetrahedra == 1);
  CHECK(result.counts.emst_edges == 3);
  CHECK(result.counts.holes == 0);
}

}  // namespace
}  // namespace tetsculpt
