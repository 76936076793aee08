// judge() of meshes with exactly one kind of fault: it is counted, its first place is named, and
// nothing else is.
#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>

#include "kernel/mesh_report.h"
#include "tests/support/meshes.h"

namespace tetsculpt {
namespace {

using testing::joined;
using testing::mesh_of;
using testing::tetrahedron;
using testing::torus;
using testing::Triangles;
using Counts = std::map<std::string, std::size_t>;
using Edge = MeshReport::Edge;

/// The kinds of which there are any.
Counts counts(const MeshReport& r) {
  Counts all = {{"unused", r.unused_points.count},  {"degenerate", r.degenerate.count},
                {"duplicates", r.duplicates.count}, {"open", r.open_edges.count},
                {"crowded", r.crowded_edges.count}, {"misdirected", r.misdirected_edges.count},
                {"torn", r.torn_vertices.count},    {"loops", r.boundary_loops}};
  std::erase_if(all, [](const auto& kind) { return kind.second == 0; });
  return all;
}

TEST_CASE("no fault") {
  const MeshReport r = judge(mesh_of(joined(torus(5, 4), tetrahedron(20, 21, 22, 23))));
  CHECK(counts(r).empty());
  CHECK(r.closed());
  CHECK(r.vertices == 24);
  CHECK(r.edges == 66);
  CHECK(r.triangles == 44);
  REQUIRE(r.shells.size() == 2);
  CHECK(r.shells[0].genus() == 1u);
  CHECK(r.shells[1].genus() == 0u);
  CHECK(r.shells[1].vertices == 4);
  CHECK(r.shells[1].edges == 6);
  CHECK(r.shell_of_point[19] == 0);
  CHECK(r.shell_of_point[20] == 1);
}

TEST_CASE("nothing at all is not closed") {
  CHECK_FALSE(judge({}).closed());
  CHECK(counts(judge({})).empty());
}

TEST_CASE("open edges and their loops") {
  Triangles open = torus(6, 6);
  open.pop_back();
  const MeshReport one = judge(mesh_of(open));
  CHECK(counts(one) == Counts{{"open", 3}, {"loops", 1}});
  CHECK(one.shells[0].genus() == 1u);
  CHECK(one.shells[0].boundary_loops == 1);
  open.erase(open.begin() + 20);  // it has no vertex of the other hole
  const MeshReport two = judge(mesh_of(open));
  CHECK(counts(two) == Counts{{"open", 6}, {"loops", 2}});
  CHECK(two.open_edges.first == Edge{0, 30});
  CHECK(two.shells[0].genus() == 1u);
  CHECK_FALSE(two.closed());
}

// Whoever walks along the boundary turns at the vertex from one hole into the other.
TEST_CASE("two holes that meet in a vertex tear it and are one loop") {
  Triangles open = torus(6, 6);
  // Triangles 0 and 60 meet in vertex 0 alone.
  open.erase(open.begin() + 60);
  open.erase(open.begin());
  CHECK(counts(judge(mesh_of(open))) == Counts{{"open", 6}, {"loops", 1}, {"torn", 1}});
}

TEST_CASE("a crowded edge, which tears its ends") {
  const MeshReport r = judge(mesh_of(joined(tetrahedron(0, 1, 2, 3), tetrahedron(1, 0, 4, 5))));
  CHECK(counts(r) == Counts{{"crowded", 1}, {"misdirected", 1}, {"torn", 2}});
  CHECK(r.crowded_edges.first == Edge{0, 1});
  CHECK(r.torn_vertices.first == 0);
  CHECK_FALSE(r.shells[0].genus().has_value());
}

TEST_CASE("a torn vertex") {
  const MeshReport r = judge(mesh_of(joined(tetrahedron(0, 1, 2, 3), tetrahedron(3, 4, 5, 6))));
  CHECK(counts(r) == Counts{{"torn", 1}});
  CHECK(r.torn_vertices.first == 3);
  CHECK(r.closed());
  CHECK_FALSE(r.shells[0].closed_manifold());
}

TEST_CASE("a triangle the wrong way around") {
  Triangles triangles = torus(5, 5);
  std::swap(triangles[7][0], triangles[7][1]);
  const MeshReport r = judge(mesh_of(triangles));
  CHECK(counts(r) == Counts{{"misdirected", 3}});
  CHECK_FALSE(r.shells[0].oriented);
}

TEST_CASE("degenerate triangles are left out of the rest") {
  Triangles triangles = tetrahedron(0, 1, 2, 3);
  for (const auto& t : Triangles{{2, 2, 1}, {1, 2, 2}, {2, 1, 2}, {3, 3, 3}})
    triangles.push_back(t);
  const MeshReport r = judge(mesh_of(triangles));
  CHECK(counts(r) == Counts{{"degenerate", 4}});
  CHECK(r.degenerate.first == 4);
  CHECK(r.triangles == 4);
  CHECK(r.closed());
}

TEST_CASE("duplicate triangles") {
  // Back to back: closed, manifold, and yet the same triangle.
  const MeshReport pillow = judge(mesh_of({{0, 1, 2}, {0, 2, 1}}));
  CHECK(counts(pillow) == Counts{{"duplicates", 1}});
  CHECK(pillow.duplicates.first == 1);
  Triangles triangles = tetrahedron(0, 1, 2, 3);
  triangles.push_back({2, 3, 1});
  triangles.push_back({3, 1, 2});
  const MeshReport r = judge(mesh_of(triangles));
  CHECK(r.duplicates.count == 2);
  CHECK(r.duplicates.first == 4);
  CHECK(r.crowded_edges.count == 3);
}

TEST_CASE("unused points") {
  TriangleMesh mesh = mesh_of(tetrahedron(0, 1, 3, 4));
  mesh.points.resize(7);
  const MeshReport r = judge(mesh);
  CHECK(counts(r) == Counts{{"unused", 3}});
  CHECK(r.unused_points.first == 2);
  CHECK(r.vertices == 4);
  CHECK(r.shell_of_point[2] == MeshReport::kNoShell);
}

}  // namespace
}  // namespace tetsculpt
