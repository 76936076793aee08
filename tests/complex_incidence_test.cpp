// Vertices, edges, triangles and tetrahedra of a complex name each other consistently, and each
// simplex exists once.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <span>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/predicates.h"
#include "tests/support/graph_oracles.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using oracle::Edge;
using oracle::Triangle;

template <class Corners>
Corners sorted(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

Triangle facet_corners(const TetComplex& complex, TetId t, int corner) {
  const auto& v = complex.vertices(t);
  const auto& c = kFacetCorners[static_cast<std::size_t>(corner)];
  return {v[c[0]], v[c[1]], v[c[2]]};
}

std::size_t bad_triangles(const TetComplex& complex, std::span<const Point3> points) {
  std::size_t bad = 0;
  for (std::uint32_t i = 0; i < complex.triangle_count(); ++i) {
    const TriangleId id{i};
    const Facet f = complex.facet(id);
    const Triangle v = complex.vertices(id);
    bad += !complex.finite(f.tet) || complex.triangle(f.tet, f.corner) != id;
    bad += v != facet_corners(complex, f.tet, f.corner);
    // Counterclockwise from outside: the tetrahedron's fourth corner is below.
    const VertexId apex = complex.vertices(f.tet)[static_cast<std::size_t>(f.corner)];
    bad += orient3d(points[+v[0]], points[+v[1]], points[+v[2]], points[+apex]) != Sign::kPositive;
    const auto edges = complex.edges(id);
    for (std::size_t k = 0; k < 3; ++k) {
      bad += complex.vertices(edges[k]) != sorted(Edge{v[(k + 1) % 3], v[(k + 2) % 3]});
    }
  }
  return bad;
}

std::size_t bad_tets(const TetComplex& complex) {
  std::size_t bad = 0;
  for (std::uint32_t i = 0; i < complex.tet_count(); ++i) {
    const TetId t{i};
    const auto& v = complex.vertices(t);
    for (int k = 0; k < 4; ++k) {
      if (!complex.finite(t) && v[static_cast<std::size_t>(k)] != kInfinite) continue;
      bad +=
          sorted(complex.vertices(complex.triangle(t, k))) != sorted(facet_corners(complex, t, k));
    }
    for (std::size_t k = 0; k < 6; ++k) {
      const Edge e = sorted(Edge{v[kEdgeCorners[k][0]], v[kEdgeCorners[k][1]]});
      if (e[1] == kInfinite) continue;
      bad += complex.vertices(complex.edge(t, static_cast<int>(k))) != e;
    }
  }
  return bad;
}

std::size_t bad_edges(const TetComplex& complex) {
  std::size_t bad = 0;
  for (std::uint32_t i = 0; i < complex.edge_count(); ++i) {
    const auto at = complex.edges(complex.triangle(EdgeId{i}));
    bad += std::find(at.begin(), at.end(), EdgeId{i}) == at.end();
    bad += !(complex.vertices(EdgeId{i})[0] < complex.vertices(EdgeId{i})[1]);
  }
  return bad;
}

void check_incidence(const std::vector<Point3>& input) {
  const DistinctPoints distinct = distinct_points(input);
  const TetComplex complex = delaunay(distinct);
  CHECK(broken_invariant(complex, distinct.points).value_or("sound") == "sound");
  CHECK(bad_triangles(complex, distinct.points) == 0);
  CHECK(bad_tets(complex) == 0);
  CHECK(bad_edges(complex) == 0);
  CHECK(oracle::finite_tets(complex).size() == complex.finite_tet_count());
  CHECK(oracle::triangles(complex).size() == complex.triangle_count());
  CHECK(oracle::flagged_edges(complex, std::vector<std::uint8_t>(complex.edge_count(), 1)).size() ==
        complex.edge_count());
  std::size_t lost = 0;
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    const auto& c = complex.vertices(complex.tet(VertexId{v}));
    lost += !complex.finite(complex.tet(VertexId{v}));
    lost += std::find(c.begin(), c.end(), VertexId{v}) == c.end();
  }
  CHECK(lost == 0);
}

TEST_CASE("small and middling solids") {
  for (const auto& sets : {oracle::small_solids(), oracle::middling_solids()}) {
    for (const auto& set : sets) {
      CAPTURE(set.name);
      check_incidence(set.points);
    }
  }
}

TEST_CASE("5000 points on a bumpy sphere") { check_incidence(point_sets::bumpy_sphere(5000, 1)); }

TEST_CASE("corner tables agree with each other") {
  for (std::size_t k = 0; k < 6; ++k) {
    const auto [a, b] = kEdgeCorners[k];
    const auto [c, d] = kEdgeCorners[5 - k];
    CHECK(kEdgeOfCorners[a][b] == k);
    CHECK(kEdgeOfCorners[b][a] == k);
    CHECK(std::set<int>{a, b, c, d}.size() == 4);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& c = kFacetCorners[i];
    CHECK(std::set<std::size_t>{i, c[0], c[1], c[2]}.size() == 4);
  }
}

}  // namespace
}  // namespace tetsculpt
