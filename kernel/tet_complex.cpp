// The complex of the paper's section 4, with triangles as one facet each and their edges reached
// through it. Edges are found by turning around each one once, from the first tetrahedron that has
// it (kernel/edge_rings): no hashing, no sorting.
#include "kernel/tet_complex.h"

#include <utility>

#include "kernel/edge_rings.h"
#include "kernel/predicates.h"

namespace tetsculpt {
namespace {

constexpr EdgeId kNoEdge{0xffffffffu};
constexpr TriangleId kNoTriangle{0xffffffffu};

/// The edges of an odd tetrahedron, given by ranks.
std::array<EdgeId, 6> in_order_of_corners(const std::array<EdgeId, 6>& e) {
  return {e[kOddEdges[0]], e[kOddEdges[1]], e[kOddEdges[2]],
          e[kOddEdges[3]], e[kOddEdges[4]], e[kOddEdges[5]]};
}

std::string name(TetId t) { return "tetrahedron " + std::to_string(+t); }

}  // namespace

TetComplex::TetComplex(LiftedHull hull, std::size_t vertex_count,
                       const std::function<void(double)>& progress)
    : finite_count_(hull.finite_count),
      tets_(std::move(hull.tets)),
      neighbors_(std::move(hull.neighbors)),
      tet_of_vertex_(vertex_count, TetId{0}) {
  for (std::size_t t = finite_count_; t-- > 0;) {
    for (const VertexId v : tets_[t]) tet_of_vertex_[+v] = TetId{static_cast<std::uint32_t>(t)};
  }
  find_triangles();
  find_edges(progress);
}

void TetComplex::find_triangles() {
  triangles_of_tet_.assign(tets_.size(), {kNoTriangle, kNoTriangle, kNoTriangle, kNoTriangle});
  facet_of_triangle_.reserve(2 * tets_.size());
  for (FacetHandle h = 0; h < 4 * finite_count_; ++h) {
    TriangleId& triangle = triangles_of_tet_[h >> 2][h & 3];
    if (triangle != kNoTriangle) continue;
    triangle = TriangleId{static_cast<std::uint32_t>(facet_of_triangle_.size())};
    const FacetHandle other = neighbors_[h >> 2][h & 3];
    triangles_of_tet_[other >> 2][other & 3] = triangle;
    facet_of_triangle_.push_back(h);
  }
}

void TetComplex::find_edges(const std::function<void(double)>& progress) {
  constexpr std::uint32_t kTellEvery = 1u << 19;
  constexpr double kBefore = 0.2;  // of the constructor's work
  const EdgeRings rings(tets_, neighbors_);
  edges_of_tet_.assign(tets_.size(), {kNoEdge, kNoEdge, kNoEdge, kNoEdge, kNoEdge, kNoEdge});
  edges_.reserve(tets_.size() + tets_.size() / 4);
  for (std::uint32_t t = 0; t < finite_count_; ++t) {
    if (progress && t % kTellEvery == 0) {
      progress(kBefore +
               (1 - kBefore) * static_cast<double>(t) / static_cast<double>(finite_count_));
    }
    const bool odd = is_odd(tets_[t]);
    for (std::size_t k = 0; k < 6; ++k) {
      const std::size_t ranked = odd ? kOddEdges[k] : k;
      if (edges_of_tet_[t][ranked] != kNoEdge) continue;
      const auto [a, b] = kEdgeCorners[ranked];
      const EdgeId e{static_cast<std::uint32_t>(edges_.size())};
      edges_.push_back({{ranked_corner(tets_[t], a), ranked_corner(tets_[t], b)},
                        triangles_of_tet_[t][kEdgeCorners[5 - k][0]]});
      rings.turn(t, ranked, [&](std::uint32_t u, std::size_t edge) { edges_of_tet_[u][edge] = e; });
    }
  }
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    if (is_odd(tets_[t])) edges_of_tet_[t] = in_order_of_corners(edges_of_tet_[t]);
  }
}

std::array<VertexId, 3> TetComplex::vertices(TriangleId t) const {
  const Facet f = facet(t);
  const auto& c = kFacetCorners[static_cast<std::size_t>(f.corner)];
  const auto& v = tets_[+f.tet];
  return {v[c[0]], v[c[1]], v[c[2]]};
}

std::array<EdgeId, 3> TetComplex::edges(TriangleId t) const {
  const Facet f = facet(t);
  const auto& c = kFacetCorners[static_cast<std::size_t>(f.corner)];
  const auto& e = edges_of_tet_[+f.tet];
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
