// What reconstruct hands out besides the surface: the graphs and the tetrahedra, over the points of
// the surface and behind them the hidden ones; nothing unless asked for.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "kernel/predicates.h"
#include "kernel/tet_complex.h"
#include "sculpt/reconstruct.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

Reconstruction kept(const std::vector<Point3>& points, Method method) {
  return reconstruct(points, {.method = method, .keep = {.graphs = true, .tetrahedra = true}});
}

using Triangle = std::array<std::uint32_t, 3>;

/// Corner 0 is the least, orientation is kept.
Triangle turned(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The facets of the tetrahedra inside that no other one inside has from its side.
std::set<Triangle> boundary(const TetMesh& mesh) {
  std::set<Triangle> out;
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    if (mesh.inside[t] == 0) continue;
    for (const auto& f : kFacetCorners) {
      const auto& c = mesh.tetrahedra[t];
      const Triangle mine{c[f[0]], c[f[1]], c[f[2]]};
      if (out.erase(turned({mine[0], mine[2], mine[1]})) == 0) out.insert(turned(mine));
    }
  }
  return out;
}

TEST_CASE("the surface is the boundary of the tetrahedra inside, which are positive") {
  for (const Method method : {Method::kGuided, Method::kPaper}) {
    const Reconstruction r = kept(point_sets::torus(0.15, 1), method);
    CHECK(r.tetrahedra.points == r.mesh.points);
    CHECK(r.tetrahedra.tetrahedra.size() == r.counts.tetrahedra);
    CHECK(r.tetrahedra.inside.size() == r.counts.tetrahedra);
    for (const auto& [a, b, c, d] : r.tetrahedra.tetrahedra) {
      const auto& p = r.tetrahedra.points;
      CHECK((orient3d(p[a], p[b], p[c], p[d]) == Sign::kPositive));
    }
    std::set<Triangle> surface;
    for (const Triangle& t : r.mesh.triangles) surface.insert(turned(t));
    CHECK(surface == boundary(r.tetrahedra));
  }
}

TEST_CASE("the graphs have the sizes that are counted, and lie in each other") {
  for (const Method method : {Method::kGuided, Method::kPaper}) {
    const Reconstruction r = kept(point_sets::uniform_cube(300, 2), method);
    const PointGraph& emst = r.graphs.emst;
    const PointGraph& gabriel = r.graphs.gabriel;
    const PointGraph& egh = r.graphs.egh;
    CHECK(r.graphs.points == r.mesh.points);
    CHECK(emst.edges.size() == r.counts.emst_edges);
    CHECK(gabriel.edges.size() == r.counts.gabriel_edges);
    CHECK(egh.edges.size() == r.counts.egh_edges);
    CHECK(egh.triangles.size() == r.counts.egh_triangles);
    const std::set in_gabriel(gabriel.edges.begin(), gabriel.edges.end());
    const std::set in_egh(egh.edges.begin(), egh.edges.end());
    CHECK(in_egh.size() == egh.edges.size());
    CHECK(std::ranges::all_of(emst.edges, [&](const auto& e) { return in_gabriel.contains(e); }));
    CHECK(std::ranges::all_of(in_gabriel, [&](const auto& e) { return in_egh.contains(e); }));
    for (const auto& t : egh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(in_egh.contains({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}));
      }
    }
  }
}

TEST_CASE("hidden points come behind the surface's, and keep their edges") {
  const std::vector<Point3> points = testing::set_with_hidden_point();
  const Reconstruction r = kept(points, Method::kPaper);
  REQUIRE(r.hidden.size() == 1);
  REQUIRE(r.graphs.points.size() == points.size());
  CHECK(r.graphs.points.back() == points[r.hidden[0]]);
  CHECK(r.tetrahedra.points == r.graphs.points);
  std::vector<bool> met(points.size(), false);
  for (const auto& [a, b] : r.graphs.emst.edges) met[a] = met[b] = true;
  CHECK(std::ranges::count(met, false) == 0);
}

TEST_CASE("nothing unless asked for, and the same surface") {
  const std::vector<Point3> points = point_sets::torus(0.2, 1);
  const Reconstruction bare = reconstruct(points);
  CHECK(bare.graphs.points.empty());
  CHECK(bare.graphs.gabriel.edges.empty());
  CHECK(bare.tetrahedra.tetrahedra.empty());
  CHECK(bare.mesh.triangles == kept(points, Method::kGuided).mesh.triangles);
}

}  // namespace
}  // namespace tetsculpt
