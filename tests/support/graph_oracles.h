#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "kernel/ids.h"
#include "kernel/point.h"
#include "kernel/tet_complex.h"
#include "tests/support/point_sets.h"

/// The complex and the graphs from their definitions, by brute force over all points; and the sets
/// to compare the kernel with them on. Ties are broken as kernel/perturbation.h says.
///
/// Points are distinct and in the order in which distinct_points() gives them; simplices are sorted
/// tuples of their places.
namespace tetsculpt::oracle {

using Edge = std::array<VertexId, 2>;
using Triangle = std::array<VertexId, 3>;
using Tet = std::array<VertexId, 4>;

/// All quadruples that span a solid and whose sphere holds no other point. Cost: n^5, for n <= 50.
std::set<Tet> delaunay(std::span<const Point3> points);
/// All pairs whose diametral sphere holds no other point.
std::set<Edge> gabriel_graph(std::span<const Point3> points);
/// The Gabriel edges and, for every two of them that share a vertex, the third edge of their
/// triangle, if they are not aligned and their smallest circumscribing sphere holds no other point.
std::set<Edge> egh_edges(std::span<const Point3> points);
/// The 3-cycles of `edges`.
std::set<Triangle> three_cycles(const std::set<Edge>& edges, std::size_t vertex_count);

/// The total order of edges: exact length, then end points.
bool shorter(std::span<const Point3> points, const Edge& e, const Edge& f);
/// Prim's algorithm on the complete graph.
std::set<Edge> emst(std::span<const Point3> points);
/// At each vertex, the shortest of all edges to other points.
std::set<Edge> nearest_neighbor_graph(std::span<const Point3> points);

// The kernel's results in the same form.
std::set<Tet> finite_tets(const TetComplex& complex);
std::set<Triangle> triangles(const TetComplex& complex);
std::set<Edge> edges_of(const TetComplex& complex, std::span<const EdgeId> ids);
std::set<Edge> flagged_edges(const TetComplex& complex, std::span<const std::uint8_t> flags);

using point_sets::NamedPoints;

/// Sets that span no solid: 0 to 3 points, equal, collinear and coplanar ones.
std::vector<NamedPoints> flat_sets();
/// 4 to about 80 distinct points: random, cospherical, on a few planes, circles or lines, one ulp
/// off, far from the origin, huge and tiny; some with duplicates.
std::vector<NamedPoints> small_solids();
/// The same kinds with 60 to 700 points.
std::vector<NamedPoints> middling_solids();

}  // namespace tetsculpt::oracle
