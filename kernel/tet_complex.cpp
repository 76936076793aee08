// The complex of the paper's section 4, with triangles as one facet each and their edges reached
// through it. One pass over the tetrahedra takes the ids of triangles and edges over from
// neighbours that came before, and makes new ones for what none of them has. Where the tetrahedra
// around an edge come in no simple order it gets several, which are found to be one where they
// meet. No hashing, no sorting, and no load that waits for another: turning around each edge once
// instead, as was done before, takes a quarter to a half longer for the whole complex.
#include "kernel/tet_complex.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "kernel/disjoint_sets.h"
#include "kernel/predicates.h"

namespace tetsculpt {
namespace {

constexpr EdgeId kNoEdge{0xffffffffu};
constexpr TriangleId kNoTriangle{0xffffffffu};

/// Corners ascend but for the last two, which may descend: then the tetrahedron is odd.
bool is_odd(const std::array<VertexId, 4>& tet) { return tet[2] > tet[3]; }

/// The rank in ascending order of a corner, or the corner of a rank.
std::size_t rank(std::size_t corner, std::uint8_t odd) { return corner ^ (odd & corner >> 1); }

/// Edge k of an odd tetrahedron by ranks, and back.
constexpr std::array<std::uint8_t, 6> kOddEdges{0, 2, 1, 4, 3, 5};

/// The edges of a tetrahedron, by the ranks of their ends.
using RankedEdges = std::array<EdgeId, 6>;

/// The edges of the facet opposite each rank. Two neighbours have these in the same order.
constexpr std::array<std::array<std::uint8_t, 3>, 4> kFacetEdges{
    {{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}}};

/// The edges that have no id yet, a bit each.
unsigned without_id(const RankedEdges& edges) {
  unsigned without = 0;
  for (std::size_t k = 0; k < 6; ++k) without |= unsigned{edges[k] == kNoEdge} << k;
  return without;
}

/// Takes over the ids that a neighbour has for the edges of their common facet. An edge that has
/// another one already is the same.
inline void take_over(RankedEdges& edges, const std::array<std::uint8_t, 3>& mine,
                      const RankedEdges& known, const std::array<std::uint8_t, 3>& theirs,
                      std::vector<std::array<EdgeId, 2>>& same) {
  const std::array other{known[theirs[0]], known[theirs[1]], known[theirs[2]]};
  const std::array here{edges[mine[0]], edges[mine[1]], edges[mine[2]]};
  unsigned differ = 0;
  for (std::size_t m = 0; m < 3; ++m) {
    differ |= unsigned{here[m] != other[m]} & unsigned{here[m] != kNoEdge};
    edges[mine[m]] = std::min(here[m], other[m]);
  }
  if (differ != 0) {
    for (std::size_t m = 0; m < 3; ++m) {
      if (here[m] != other[m] && here[m] != kNoEdge) same.push_back({here[m], other[m]});
    }
  }
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
  find_simplices(progress);
}

void TetComplex::find_simplices(const std::function<void(double)>& progress) {
  constexpr std::uint32_t kTellEvery = 1u << 19;
  constexpr double kOfWork = 0.85;  // numbering the edges is the rest
  const auto count = static_cast<std::uint32_t>(tets_.size());
  const auto finite_count = static_cast<std::uint32_t>(finite_count_);
  LargeArray<std::uint8_t> odd_tets(count);
  for (std::size_t t = 0; t < count; ++t) odd_tets[t] = is_odd(tets_[t]);
  triangles_of_tet_.resize(count);
  edges_of_tet_.resize(count);
  facet_of_triangle_.reserve((std::size_t{3} * finite_count + count) / 2);
  edges_.reserve(count + count / 4);
  std::vector<std::array<EdgeId, 2>> same;
  // Pointers of its own: a member's would be loaded again after each element written.
  const std::uint8_t* const odd = odd_tets.data();
  const auto* const neighbors = neighbors_.data();
  auto* const triangles = triangles_of_tet_.data();
  auto* const edges_of = edges_of_tet_.data();
  for (std::uint32_t t = 0; t < count; ++t) {
    if (progress && t % kTellEvery == 0) {
      progress(kOfWork * static_cast<double>(t) / static_cast<double>(count));
    }
    RankedEdges edges;
    edges.fill(kNoEdge);
    for (std::uint32_t i = 0; i < 4; ++i) {
      const FacetHandle h = neighbors[t][i];
      const std::uint32_t u = h >> 2;
      if (u < t && u < finite_count) {
        triangles[t][i] = triangles[u][h & 3];
        take_over(edges, kFacetEdges[rank(i, odd[t])], edges_of[u],
                  kFacetEdges[rank(h & 3, odd[u])], same);
      } else if (t < finite_count) {
        triangles[t][i] = TriangleId{static_cast<std::uint32_t>(facet_of_triangle_.size())};
        facet_of_triangle_.push_back(4 * t + i);
      } else {
        triangles[t][i] = kNoTriangle;
      }
    }
    for (unsigned left = t < finite_count ? without_id(edges) : 0; left != 0; left &= left - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      const auto [a, b] = kEdgeCorners[k];
      edges[k] = EdgeId{static_cast<std::uint32_t>(edges_.size())};
      edges_.push_back({{tets_[t][rank(a, odd[t])], tets_[t][rank(b, odd[t])]},
                        triangles[t][rank(kEdgeCorners[5 - k][0], odd[t])]});
    }
    edges_of[t] = edges;
  }
  number_edges(same, odd_tets);
}

/// Of the ids of one edge the first is kept; closes the gaps, and puts each tetrahedron's edges in
/// the order of its corners.
void TetComplex::number_edges(std::span<const std::array<EdgeId, 2>> same,
                              const LargeArray<std::uint8_t>& odd) {
  DisjointSets ids(edges_.size());
  for (const auto& [a, b] : same) ids.unite(+a, +b);
  LargeArray<EdgeId> number(edges_.size());
  std::uint32_t count = 0;
  for (std::uint32_t e = 0; e < edges_.size(); ++e) {
    const std::uint32_t first = ids.find(e);
    if (first == e) edges_[count] = edges_[e];
    number[e] = first == e ? EdgeId{count++} : number[first];
  }
  edges_.resize(count);
  const auto renumber = [&](std::size_t first, std::size_t last, auto&& numbered) {
    for (std::size_t t = first; t < last; ++t) {
      const RankedEdges edges = edges_of_tet_[t];
      for (std::size_t k = 0; k < 6; ++k) {
        edges_of_tet_[t][k] = numbered(edges[odd[t] ? kOddEdges[k] : k]);
      }
    }
  };
  renumber(0, finite_count_, [&](EdgeId e) { return number[+e]; });
  renumber(finite_count_, tets_.size(), [&](EdgeId e) { return e == kNoEdge ? e : number[+e]; });
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
