// broken_invariant of a mesh passes closed oriented manifolds and sees every planted fault.
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "kernel/triangle_mesh.h"

namespace tetsculpt {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const Triangles kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
const Triangles kAtVertex3{{3, 5, 4}, {3, 4, 6}, {4, 5, 6}, {5, 3, 6}};
const Triangles kAtEdge01{{1, 4, 0}, {1, 0, 5}, {0, 4, 5}, {4, 1, 5}};
const Triangles kApart{{4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}};
// The projective plane with 6 vertices: closed, but not orientable.
const Triangles kProjectivePlane{{0, 1, 4}, {0, 4, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 1},
                                 {1, 2, 5}, {1, 3, 2}, {1, 4, 3}, {2, 4, 5}, {3, 4, 5}};

/// The complaint about these triangles over 8 points, or "sound".
std::string complaint(const Triangles& triangles) {
  return broken_invariant(TriangleMesh{std::vector<Point3>(8), triangles}).value_or("sound");
}

Triangles joined(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST_CASE("sound meshes") {
  CHECK(complaint(kTetrahedron) == "sound");
  CHECK(complaint(joined(kTetrahedron, kApart)) == "sound");
  Triangles inward = kTetrahedron;
  for (auto& t : inward) std::swap(t[0], t[1]);
  CHECK(complaint(inward) == "sound");
}

TEST_CASE("indices") {
  for (std::uint32_t bad : {8u, 0xffffffffu}) {
    Triangles triangles = kTetrahedron;
    triangles[2][1] = bad;
    CHECK(complaint(triangles) == "triangle 2 names a point that is not there");
  }
}

TEST_CASE("degenerate triangles") {
  for (std::size_t i = 0; i < 3; ++i) {
    Triangles triangles = kTetrahedron;
    triangles[1][i] = triangles[1][(i + 1) % 3];
    CHECK(complaint(triangles) == "triangle 1 is degenerate");
  }
}

TEST_CASE("duplicates, turned or flipped") {
  CHECK(complaint(joined(kTetrahedron, {{0, 2, 1}})) == "a triangle occurs twice");
  CHECK(complaint(joined(kTetrahedron, {{2, 1, 0}})) == "a triangle occurs twice");
  CHECK(complaint(joined(kTetrahedron, {{0, 1, 2}})) == "a triangle occurs twice");
  CHECK(complaint({{0, 1, 2}, {2, 1, 0}}) == "a triangle occurs twice");
}

TEST_CASE("edges without two triangles") {
  Triangles open = kTetrahedron;
  open.pop_back();
  CHECK(complaint(open) == "an edge does not have exactly two triangles");
  CHECK(complaint(joined(kTetrahedron, kAtEdge01)) ==
        "an edge does not have exactly two triangles");
  CHECK(complaint(joined(kTetrahedron, {{0, 1, 4}})) ==
        "an edge does not have exactly two triangles");
}

TEST_CASE("orientation") {
  for (std::size_t t = 0; t < 4; ++t) {
    Triangles triangles = kTetrahedron;
    std::swap(triangles[t][1], triangles[t][2]);
    CHECK(complaint(triangles) == "two triangles run along an edge in the same direction");
  }
  CHECK(complaint(kProjectivePlane) == "two triangles run along an edge in the same direction");
}

TEST_CASE("two shells that touch at a vertex") {
  CHECK(complaint(joined(kTetrahedron, kAtVertex3)) ==
        "a vertex has more than one cycle of triangles");
}

}  // namespace
}  // namespace tetsculpt
