// topology() of meshes built by hand.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/triangle_mesh.h"
#include "tests/support/meshes.h"

namespace tetsculpt {
namespace {

using testing::joined;
using testing::mesh_of;
using testing::tetrahedron;
using testing::torus;
using testing::Triangles;

/// A strip of n squares whose ends are joined after half a turn if `twisted` says so.
enum class Strip { kPlain, kTwisted };
Triangles strip(std::uint32_t n, Strip kind) {
  Triangles triangles;
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t next[2] = {2 * ((i + 1) % n), 2 * ((i + 1) % n) + 1};
    if (i + 1 == n && kind == Strip::kTwisted) std::swap(next[0], next[1]);
    triangles.push_back({2 * i, next[0], 2 * i + 1});
    triangles.push_back({2 * i + 1, next[0], next[1]});
  }
  return triangles;
}

/// closed, edge-manifold, vertex-manifold, oriented; components, genus.
void check(const Triangles& triangles, const Topology& expected) {
  const Topology t = topology(mesh_of(triangles));
  CHECK(t.closed == expected.closed);
  CHECK(t.edge_manifold == expected.edge_manifold);
  CHECK(t.vertex_manifold == expected.vertex_manifold);
  CHECK(t.oriented == expected.oriented);
  CHECK(t.components == expected.components);
  CHECK(t.genus == expected.genus);
}

TEST_CASE("closed manifolds") {
  check(tetrahedron(0, 1, 2, 3), {true, true, true, true, 1, 0});
  check(joined(tetrahedron(0, 1, 2, 3), tetrahedron(4, 5, 6, 7)), {true, true, true, true, 2, 0});
  check(torus(3, 3), {true, true, true, true, 1, 1});
  check(torus(7, 12), {true, true, true, true, 1, 1});
  check(joined(torus(5, 4), joined(torus(4, 6, 20), tetrahedron(44, 45, 46, 47))),
        {true, true, true, true, 3, 2});
}

TEST_CASE("genus 2: two tori joined through a triangle") {
  Triangles first = torus(5, 5);
  Triangles second = torus(5, 5, 25);
  const auto hole = first.back();
  const auto other = second.back();
  first.pop_back();
  second.pop_back();
  Triangles both = joined(first, second);
  // The second hole's corners become the first's, in opposite order.
  const std::uint32_t twin[3] = {hole[0], hole[2], hole[1]};
  for (auto& t : both) {
    for (auto& v : t) {
      const auto k = std::find(other.begin(), other.end(), v) - other.begin();
      if (k < 3) v = twin[k];
    }
  }
  check(both, {true, true, true, true, 1, 2});
}

TEST_CASE("open meshes") {
  check({{0, 1, 2}}, {false, true, true, true, 1, 0});
  check({{0, 1, 2}, {0, 2, 3}}, {false, true, true, true, 1, 0});
  Triangles open = torus(6, 5);
  open.pop_back();
  check(open, {false, true, true, true, 1, 0});
  check(strip(8, Strip::kPlain), {false, true, true, true, 1, 0});
  check({}, {false, true, true, true, 0, 0});
}

TEST_CASE("shared vertices and edges") {
  check(joined(tetrahedron(0, 1, 2, 3), tetrahedron(3, 4, 5, 6)), {true, true, false, true, 1, 0});
  check({{0, 1, 2}, {2, 3, 4}}, {false, true, false, true, 1, 0});
  // Three triangles at an edge.
  const Topology book = topology(mesh_of({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  CHECK_FALSE(book.edge_manifold);
  CHECK_FALSE(book.oriented);
}

// At an end of the shared edge the triangles form two cycles, not one.
TEST_CASE("two tetrahedra that share an edge") {
  check(joined(tetrahedron(0, 1, 2, 3), tetrahedron(1, 0, 4, 5)),
        {false, false, false, false, 1, 0});
}

TEST_CASE("orientation") {
  Triangles flipped = tetrahedron(0, 1, 2, 3);
  std::swap(flipped[2][0], flipped[2][1]);
  check(flipped, {true, true, true, false, 1, 0});
  check(strip(8, Strip::kTwisted), {false, true, true, false, 1, 0});
}

TEST_CASE("unused points do not count") {
  TriangleMesh mesh = mesh_of(tetrahedron(0, 1, 2, 3));
  mesh.points.resize(20);
  CHECK(topology(mesh).components == 1);
  CHECK(topology(mesh).genus == 0);
}

}  // namespace
}  // namespace tetsculpt
