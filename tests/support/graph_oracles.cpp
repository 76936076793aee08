#include "tests/support/graph_oracles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernel/perturbation.h"
#include "kernel/predicates.h"
#include "tests/support/point_sets.h"

namespace tetsculpt::oracle {
namespace {

VertexId id(std::size_t i) { return VertexId{static_cast<std::uint32_t>(i)}; }

/// No point is inside, the corners aside.
template <std::size_t kCorners, class Inside>
bool empty(std::span<const Point3> points, const std::array<std::size_t, kCorners>& corners,
           const Inside& inside) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::find(corners.begin(), corners.end(), i) != corners.end()) continue;
    if (inside(points[i])) return false;
  }
  return true;
}

bool has_empty_sphere(std::span<const Point3> points, const std::array<std::size_t, 4>& corners) {
  Point3 a = points[corners[0]];
  Point3 b = points[corners[1]];
  const Point3 c = points[corners[2]];
  const Point3 d = points[corners[3]];
  const Sign orientation = orient3d(a, b, c, d);
  if (orientation == Sign::kZero) return false;
  if (orientation == Sign::kNegative) std::swap(a, b);
  return empty(points, corners,
               [&](const Point3& p) { return in_perturbed_sphere(a, b, c, d, p); });
}

bool has_empty_sphere(std::span<const Point3> points, const std::array<std::size_t, 3>& corners) {
  const Point3& a = points[corners[0]];
  const Point3& b = points[corners[1]];
  const Point3& c = points[corners[2]];
  if (collinear(a, b, c)) return false;
  return empty(points, corners,
               [&](const Point3& p) { return in_perturbed_equatorial_sphere(a, b, c, p); });
}

}  // namespace

std::set<Tet> delaunay(std::span<const Point3> points) {
  std::set<Tet> tets;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        for (std::size_t l = k + 1; l < n; ++l) {
          if (has_empty_sphere(points, std::array{i, j, k, l})) {
            tets.insert({id(i), id(j), id(k), id(l)});
          }
        }
      }
    }
  }
  return tets;
}

std::set<Edge> gabriel_graph(std::span<const Point3> points) {
  std::set<Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      if (empty(points, std::array{i, j}, [&](const Point3& p) {
            return in_perturbed_diametral_sphere(points[i], points[j], p);
          })) {
        edges.insert({id(i), id(j)});
      }
    }
  }
  return edges;
}

std::set<Edge> egh_edges(std::span<const Point3> points) {
  const std::set<Edge> gabriel = gabriel_graph(points);
  std::vector<std::vector<std::size_t>> neighbors(points.size());
  for (const auto& [a, b] : gabriel) {
    neighbors[+a].push_back(+b);
    neighbors[+b].push_back(+a);
  }
  std::set<Edge> edges = gabriel;
  for (std::size_t v = 0; v < points.size(); ++v) {
    for (const std::size_t a : neighbors[v]) {
      for (const std::size_t b : neighbors[v]) {
        if (a < b && has_empty_sphere(points, std::array{v, a, b})) edges.insert({id(a), id(b)});
      }
    }
  }
  return edges;
}

std::set<Triangle> three_cycles(const std::set<Edge>& edges, std::size_t vertex_count) {
  std::set<Triangle> cycles;
  for (const auto& [a, b] : edges) {
    for (std::size_t c = +b + 1; c < vertex_count; ++c) {
      if (edges.contains({a, id(c)}) && edges.contains({b, id(c)})) cycles.insert({a, b, id(c)});
    }
  }
  return cycles;
}

bool shorter(std::span<const Point3> points, const Edge& e, const Edge& f) {
  const Sign s = compare_lengths(points[+e[0]], points[+e[1]], points[+f[0]], points[+f[1]]);
  return s == Sign::kZero ? e < f : s == Sign::kNegative;
}

std::set<Edge> emst(std::span<const Point3> points) {
  std::set<Edge> tree;
  std::vector<Edge> links;  // per vertex outside the tree, its shortest edge to the tree
  for (std::size_t i = 1; i < points.size(); ++i) links.push_back({id(0), id(i)});
  std::vector<bool> inside(points.size(), false);
  if (!points.empty()) inside[0] = true;
  while (!links.empty()) {
    const auto next =
        std::min_element(links.begin(), links.end(),
                         [&](const Edge& e, const Edge& f) { return shorter(points, e, f); });
    const VertexId added = inside[+(*next)[0]] ? (*next)[1] : (*next)[0];
    tree.insert(*next);
    inside[+added] = true;
    links.erase(next);
    for (Edge& link : links) {
      const VertexId v = inside[+link[0]] ? link[1] : link[0];
      const Edge other{std::min(v, added), std::max(v, added)};
      if (shorter(points, other, link)) link = other;
    }
  }
  return tree;
}

std::set<Edge> nearest_neighbor_graph(std::span<const Point3> points) {
  std::set<Edge> graph;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<Edge> edges;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (j != i) edges.push_back({id(std::min(i, j)), id(std::max(i, j))});
    }
    if (edges.empty()) continue;
    graph.insert(*std::min_element(edges.begin(), edges.end(), [&](const Edge& e, const Edge& f) {
      return shorter(points, e, f);
    }));
  }
  return graph;
}

std::set<Tet> finite_tets(const TetComplex& complex) {
  std::set<Tet> tets;
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) {
    Tet corners = complex.vertices(TetId{t});
    std::sort(corners.begin(), corners.end());
    tets.insert(corners);
  }
  return tets;
}

std::set<Triangle> triangles(const TetComplex& complex) {
  std::set<Triangle> result;
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    Triangle corners = complex.vertices(TriangleId{t});
    std::sort(corners.begin(), corners.end());
    result.insert(corners);
  }
  return result;
}

std::set<Edge> edges_of(const TetComplex& complex, std::span<const EdgeId> ids) {
  std::set<Edge> edges;
  for (const EdgeId e : ids) edges.insert(complex.vertices(e));
  return edges;
}

std::set<Edge> flagged_edges(const TetComplex& complex, std::span<const std::uint8_t> flags) {
  std::set<Edge> edges;
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    if (flags[e]) edges.insert(complex.vertices(EdgeId{e}));
  }
  return edges;
}

namespace {

using point_sets::Random;

/// Every third coordinate moves to a neighbouring double.
std::vector<Point3> one_ulp_moved(std::vector<Point3> points, std::uint64_t seed) {
  Random random(seed);
  for (Point3& p : points) {
    for (double* x : {&p.x, &p.y, &p.z}) {
      if (random.below(3) == 0) *x = std::nextafter(*x, random.below(2) == 0 ? -1e300 : 1e300);
    }
  }
  return points;
}

std::vector<Point3> rounded_to_7_decimals(std::vector<Point3> points) {
  for (Point3& p : points) {
    for (double* x : {&p.x, &p.y, &p.z}) *x = std::round(*x * 1e7) / 1e7;
  }
  return points;
}

/// The integer points of a circle, at several heights: cocircular, and pairwise cospherical
/// circles.
std::vector<Point3> circles(long squared_radius, int heights) {
  std::vector<Point3> points;
  for (const Point3& p : point_sets::lattice_sphere(squared_radius)) {
    for (int h = 0; h < heights && p.z == 0; ++h) points.push_back({p.x, p.y, 3.0 * h});
  }
  return points;
}

std::vector<Point3> on_line(int n, const Point3& step) {
  std::vector<Point3> points;
  for (int i = 0; i < n; ++i) points.push_back({i * step.x, i * step.y, i * step.z});
  return points;
}

/// {0..side-1}^2 in the plane spanned by u and v.
std::vector<Point3> in_plane(int side, const Point3& u, const Point3& v) {
  std::vector<Point3> points;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      points.push_back({i * u.x + j * v.x, i * u.y + j * v.y, i * u.z + j * v.z});
    }
  }
  return points;
}

}  // namespace

std::vector<NamedPoints> flat_sets() {
  return {
      {"no point", {}},
      {"one point", {{1, 2, 3}}},
      {"two points", {{1, 2, 3}, {1, 2, 4}}},
      {"three points", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
      {"all equal", std::vector<Point3>(100, {0.1, -0.2, 0.3})},
      {"four equal points and two others", {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}},
      {"on an axis", on_line(50, {0, 0, 1})},
      {"on a line", on_line(50, {1, -2, 3})},
      {"in a coordinate plane", in_plane(8, {1, 0, 0}, {0, 0, 1})},
      {"in a plane", in_plane(8, {1, 2, 3}, {-3, 1, 2})},
      {"on a circle", circles(325, 1)},
      {"in a huge plane", point_sets::scaled(in_plane(8, {1, 2, 3}, {-3, 1, 2}), 0x1p490)}};
}

std::vector<NamedPoints> small_solids() {
  using namespace point_sets;
  const Point3 far{1e7, -2e7, 3e7};
  return {{"tetrahedron", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
          {"point in a tetrahedron", {{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}, {1, 1, 1}}},
          {"point on an edge", {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}}},
          {"cube", grid(2)},
          {"octahedron", lattice_sphere(1)},
          {"octahedron and centre", joined(lattice_sphere(1), {{0, 0, 0}})},
          {"10 uniform", uniform_cube(10, 1)},
          {"45 uniform", uniform_cube(45, 2)},
          {"80 uniform", uniform_cube(80, 3)},
          {"grid of 27", grid(3)},
          {"grid of 64", grid(4)},
          {"grid of 64, spacing 0.1", grid(4, 0.1)},
          {"grid of 27, one ulp moved", one_ulp_moved(translated(grid(3), {1, 1, 1}), 4)},
          {"grid of 64, one ulp moved", one_ulp_moved(translated(grid(4), {1, 1, 1}), 5)},
          {"lattice sphere of 24", lattice_sphere(5)},
          {"lattice sphere of 30 and centre", joined(lattice_sphere(9), {{0, 0, 0}})},
          {"lattice sphere of 72", lattice_sphere(26)},
          {"two lattice spheres", joined(lattice_sphere(5), lattice_sphere(6))},
          {"random lattice with duplicates", random_lattice(60, 4, 6)},
          {"thin lattice with duplicates", scaled(random_lattice(40, 3, 7), 0.1)},
          {"clusters", clusters(45, 8)},
          {"skew lines", skew_lines(14)},
          {"plane and apex", plane_and_apex(30, 9)},
          {"square lattice and apex", joined(in_plane(6, {1, 0, 0}, {0, 1, 0}), {{2, 3, 1}})},
          {"prism over 12 cocircular points", circles(25, 2)},
          {"3 circles of 16", circles(65, 3)},
          {"circle of 36 and apex", joined(circles(1105, 1), {{0, 0, 7}})},
          {"60 on a torus", random_torus(60, 10)},
          {"45 uniform, far off", translated(uniform_cube(45, 11), far)},
          {"grid of 27 times 2^490", scaled(grid(3, 0.1), 0x1p490)},
          {"40 uniform times 2^-460", scaled(uniform_cube(40, 12), 0x1p-460)},
          {"cube, 7 decimals", rounded_to_7_decimals(cube_surface(0.4, 13))}};
}

std::vector<NamedPoints> middling_solids() {
  using namespace point_sets;
  const Point3 far{1e7, -2e7, 3e7};
  return {{"400 uniform", uniform_cube(400, 21)},
          {"grid of 125", grid(5)},
          {"grid of 125, spacing 0.1", grid(5, 0.1)},
          {"grid of 216, one ulp moved", one_ulp_moved(translated(grid(6), {1, 1, 1}), 22)},
          {"lattice sphere of 168", lattice_sphere(101)},
          {"random lattice with duplicates", random_lattice(500, 6, 23)},
          {"clusters", clusters(300, 24)},
          {"skew lines", skew_lines(30)},
          {"plane and apex", plane_and_apex(300, 25)},
          {"square lattice and apex", joined(in_plane(14, {1, 0, 0}, {0, 1, 0}), {{5, 6, 1}})},
          {"5 circles of 36", circles(1105, 5)},
          {"torus", torus(0.25, 26)},
          {"cube, 7 decimals", rounded_to_7_decimals(cube_surface(0.12, 27))},
          {"300 uniform, far off", translated(uniform_cube(300, 28), far)},
          {"grid of 125 times 2^490", scaled(grid(5, 0.1), 0x1p490)},
          {"300 on a bumpy sphere times 2^-460", scaled(bumpy_sphere(300, 29), 0x1p-460)}};
}

}  // namespace tetsculpt::oracle
