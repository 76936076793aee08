// The story of a reconstruction: its record ends with the mesh, and its graphs are over the mesh's
// vertices and the hidden points.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "sculpt/reconstruct.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

Reconstruction told(const std::vector<Point3>& points, Method method) {
  return reconstruct(points, {.method = method, .keep = {.graphs = true, .record = true}});
}

/// Points in reverse and some twice, so that no two numberings agree by chance.
std::vector<Point3> awkward(std::vector<Point3> points) {
  std::ranges::reverse(points);
  points.insert(points.begin(), points.back());
  return points;
}

TEST_CASE("the record's last step is the mesh, triangle for triangle") {
  for (const Method method : {Method::kGuided, Method::kPaper}) {
    for (const testing::NamedSet& set : testing::small_sets()) {
      INFO(set, ", method ", static_cast<int>(method));
      const Reconstruction r = told(awkward(set.points), method);
      const SculptingRecord& record = r.record;
      const std::size_t vertices = r.mesh.points.size() + r.hidden.size();
      REQUIRE(vertices == r.counts.vertices);
      REQUIRE_FALSE(broken_invariant(record, vertices));
      CHECK(surface_after(record, record.step_count) == r.mesh.triangles);
    }
  }
}

TEST_CASE("the tree spans all vertices, hidden ones too, with their shortest edges") {
  for (const Method method : {Method::kGuided, Method::kPaper}) {
    const std::vector<Point3> input = awkward(testing::set_with_hidden_point());
    const Reconstruction r = told(input, method);
    if (method == Method::kPaper) REQUIRE(r.hidden.size() == 1);
    std::vector<Point3> points = r.mesh.points;
    for (const std::size_t i : r.hidden) points.push_back(input[i]);
    REQUIRE(r.graphs.emst.edges.size() == points.size() - 1);
    const auto length = [&](std::size_t a, std::size_t b) {
      const Point3 &p = points[a], &q = points[b];
      return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z);
    };
    double sum = 0;
    for (const auto& [a, b] : r.graphs.emst.edges) sum += length(a, b);
    // Prim's algorithm on all pairs.
    std::vector<double> near(points.size(), 1e300);
    std::vector<bool> in(points.size(), false);
    double least = 0;
    for (std::size_t next = 0, k = 0; k < points.size(); ++k) {
      in[next] = true;
      if (k > 0) least += near[next];
      for (std::size_t i = 0; i < points.size(); ++i) near[i] = std::min(near[i], length(next, i));
      for (std::size_t i = 0, best = points.size(); i < points.size(); ++i) {
        if (!in[i] && (best == points.size() || near[i] < near[best])) next = best = i;
      }
    }
    CHECK(sum == doctest::Approx(least));
  }
}

TEST_CASE("the EGH has as many triangles as counted, none of them on equal vertices") {
  const Reconstruction r = told(point_sets::torus(0.3, 1), Method::kGuided);
  CHECK(r.graphs.egh.triangles.size() == r.counts.egh_triangles);
  for (const auto& [a, b, c] : r.graphs.egh.triangles) {
    REQUIRE((a != b && b != c && c != a && std::max({a, b, c}) < r.mesh.points.size()));
  }
}

TEST_CASE("nothing is recorded unless asked for, and the surface does not depend on it") {
  const std::vector<Point3> points = point_sets::random_lattice(60, 4, 3);
  for (const Method method : {Method::kGuided, Method::kPaper}) {
    const Reconstruction silent = reconstruct(points, {.method = method});
    CHECK(silent.record.triangles.empty());
    CHECK(silent.graphs.emst.edges.empty());
    CHECK(silent.graphs.egh.triangles.empty());
    CHECK(silent.mesh.triangles == told(points, method).mesh.triangles);
  }
}

}  // namespace
}  // namespace tetsculpt
