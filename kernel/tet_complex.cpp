// The complex of the paper's section 4, with triangles as one facet each and their edges reached
// through it.
#include "kernel/tet_complex.h"

#include <algorithm>
#include <utility>

#include "kernel/predicates.h"

namespace tetsculpt {
namespace {

std::string name(TetId t) { return "tetrahedron " + std::to_string(+t); }

}  // namespace

TetComplex::TetComplex(LiftedHull hull, std::size_t vertex_count,
                       const std::function<void(double)>& progress, int threads)
    : hull_(std::move(hull)),
      simplices_(find_simplices(hull_, {.threads = threads, .progress = progress})),
      tet_of_vertex_(vertex_count, TetId{0}) {
  for (std::size_t t = hull_.finite_count; t-- > 0;) {
    for (const VertexId v : hull_.tets[t]) {
      tet_of_vertex_[+v] = TetId{static_cast<std::uint32_t>(t)};
    }
  }
}

std::array<VertexId, 3> TetComplex::vertices(TriangleId t) const {
  const Facet f = facet(t);
  const auto& c = kFacetCorners[static_cast<std::size_t>(f.corner)];
  const auto& v = hull_.tets[+f.tet];
  return {v[c[0]], v[c[1]], v[c[2]]};
}

std::array<EdgeId, 3> TetComplex::edges(TriangleId t) const {
  const Facet f = facet(t);
  const auto& c = kFacetCorners[static_cast<std::size_t>(f.corner)];
  const auto& e = simplices_.edges_of_tet[+f.tet];
  return {e[kEdgeOfCorners[c[1]][c[2]]], e[kEdgeOfCorners[c[2]][c[0]]],
          e[kEdgeOfCorners[c[0]][c[1]]]};
}

namespace {

std::optional<std::string> broken_tet(const TetComplex& complex, TetId t,
                                      std::span<const Point3> points) {
  const auto& v = complex.vertices(t);
  int infinite = 0;
  for (const VertexId c : v) {
    if (c == kInfinite)
      ++infinite;
    else if (+c >= points.size())
      return name(t) + " has a corner out of range";
  }
  if (!(v[0] < v[1] && v[1] < std::min(v[2], v[3])))
    return name(t) + " has its corners out of order";
  if (infinite != (complex.finite(t) ? 0 : 1)) return name(t) + " has a wrong corner at infinity";
  if (infinite == 0 &&
      orient3d(points[+v[0]], points[+v[1]], points[+v[2]], points[+v[3]]) != Sign::kPositive) {
    return name(t) + " is not positively oriented";
  }
  for (int i = 0; i < 4; ++i) {
    const Facet other = complex.across(t, i);
    const Facet back = complex.across(other.tet, other.corner);
    if (back.tet != t || back.corner != i) return name(t) + " is no neighbour of its neighbour";
    // The shared facet must have the same corners in opposite order.
    const auto& w = complex.vertices(other.tet);
    const auto& mine = kFacetCorners[static_cast<std::size_t>(i)];
    const auto& theirs = kFacetCorners[static_cast<std::size_t>(other.corner)];
    bool opposite = false;
    for (std::size_t shift = 0; shift < 3; ++shift) {
      opposite =
          opposite || (v[mine[0]] == w[theirs[shift]] && v[mine[1]] == w[theirs[(shift + 2) % 3]] &&
                       v[mine[2]] == w[theirs[(shift + 1) % 3]]);
    }
    if (!opposite)
      return name(t) + " does not match its neighbour across facet " + std::to_string(i);
    if (v[static_cast<std::size_t>(i)] != kInfinite && complex.finite(t) &&
        complex.triangle(t, i) != complex.triangle(other.tet, other.corner)) {
      return name(t) + " disagrees with a neighbour on their triangle";
    }
  }
  return std::nullopt;
}

std::optional<std::string> broken_edge(const TetComplex& complex, EdgeId e) {
  const VertexId a = complex.vertices(e)[0];
  const VertexId b = complex.vertices(e)[1];
  const std::string edge = "edge " + std::to_string(+e);
  if (!(a < b)) return edge + " has its end points out of order";
  bool good = true;
  complex.turn(e, [&](Facet f, VertexId third) {
    const auto& v = complex.vertices(f.tet);
    const int i = corner_of(v, a);
    const int j = corner_of(v, b);
    good =
        good && third != a && third != b &&
        complex.edge(f.tet,
                     kEdgeOfCorners[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]) == e;
    return good;
  });
  if (!good) return edge + " is not the edge of a tetrahedron around it";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> broken_invariant(const TetComplex& complex,
                                            std::span<const Point3> points) {
  if (complex.tet_count() == 0) return std::nullopt;
  if (complex.vertex_count() != points.size()) return "vertices and points differ in number";
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    if (auto broken = broken_tet(complex, TetId{t}, points)) return broken;
  }
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    if (auto broken = broken_edge(complex, EdgeId{e})) return broken;
  }
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    const auto& c = complex.vertices(complex.tet(VertexId{v}));
    if (c[0] != VertexId{v} && c[1] != VertexId{v} && c[2] != VertexId{v} && c[3] != VertexId{v}) {
      return "vertex " + std::to_string(v) + " is no corner of its tetrahedron";
    }
  }
  // A tetrahedralized ball: Euler's relation over finite simplices.
  const auto euler = static_cast<std::int64_t>(complex.vertex_count()) -
                     static_cast<std::int64_t>(complex.edge_count()) +
                     static_cast<std::int64_t>(complex.triangle_count()) -
                     static_cast<std::int64_t>(complex.finite_tet_count());
  if (euler != 1) return "Euler's relation gives " + std::to_string(euler) + " instead of 1";
  return std::nullopt;
}

}  // namespace tetsculpt
