#include "tests/support/sculpt_stages.h"

#include <cstdint>
#include <numeric>
#include <utility>

#include "kernel/delaunay.h"
#include "kernel/egh.h"
#include "kernel/emst.h"
#include "kernel/gabriel.h"
#include "sculpt/boundary.h"
#include "sculpt/star_inspector.h"
#include "tests/support/point_sets.h"

namespace tetsculpt::testing {

std::vector<TetId> Stages::tets() const {
  std::vector<TetId> ids;
  for (std::uint32_t t = 0; t < complex.finite_tet_count(); ++t) ids.push_back(TetId{t});
  return ids;
}

Flags Stages::random_labels(double share, std::uint64_t seed) const {
  point_sets::Random random(seed);
  Flags inside(complex.tet_count(), 0);
  for (const TetId t : tets()) inside[+t] = random.uniform() < share;
  return inside;
}

TriangleMesh Stages::surface(const Flags& inside) const {
  TriangleMesh mesh{{distinct.points.begin(), distinct.points.end()}, {}};
  const auto index = [](VertexId v) { return static_cast<std::uint32_t>(+v); };
  for (const auto& [a, b, c] : boundary_triangles(complex, inside)) {
    mesh.triangles.push_back({index(a), index(b), index(c)});
  }
  return mesh;
}

bool Stages::all_stars_good(const VertexStars& stars, const Flags& inside) const {
  StarInspector inspector(complex, stars);
  for (std::uint32_t v = 0; v < complex.vertex_count(); ++v) {
    if (inspector.parts(VertexId{v}, inside).excess() > 0) return false;
  }
  return true;
}

Sculpture Stages::sculpt(Criterion criterion, PaperOptions::Stop stop) const {
  PaperOptions options;
  options.criterion = criterion;
  options.stop = stop;
  return sculpt_paper(points(), complex, constraints, options);
}

Stages stages(DistinctPoints distinct, TetComplex complex) {
  Stages s;
  s.distinct = std::move(distinct);
  s.complex = std::move(complex);
  const Flags gabriel = gabriel_edges(s.points(), s.complex);
  s.constraints.egh_triangles =
      extended_gabriel_hypergraph(s.points(), s.complex, gabriel).triangles;
  s.constraints.emst_edges.assign(s.complex.edge_count(), 0);
  for (const EdgeId e : emst(s.complex, edges_by_length(s.points(), s.complex, gabriel))) {
    s.constraints.emst_edges[+e] = 1;
  }
  return s;
}

Stages stages(std::span<const Point3> input) {
  DistinctPoints distinct = distinct_points(input);
  TetComplex complex = delaunay(distinct);
  return stages(std::move(distinct), std::move(complex));
}

TetComplex renumbered(const TetComplex& complex, std::uint64_t seed) {
  point_sets::Random random(seed);
  std::vector<std::uint32_t> place(complex.tet_count());
  std::iota(place.begin(), place.end(), 0u);
  // The finite tetrahedra stay in front.
  for (std::size_t i = complex.finite_tet_count(); i > 1; --i) {
    std::swap(place[i - 1], place[random.below(i)]);
  }
  LiftedHull hull;
  hull.finite_count = complex.finite_tet_count();
  hull.tets.resize(complex.tet_count());
  hull.neighbors.resize(complex.tet_count());
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const Facet other = complex.across(TetId{t}, static_cast<int>(i));
      const auto corner = static_cast<std::uint32_t>(other.corner);
      hull.tets[place[t]][i] = complex.vertices(TetId{t})[i];
      hull.neighbors[place[t]][i] = 4 * place[+other.tet] + corner;
    }
  }
  return TetComplex(std::move(hull), complex.vertex_count());
}

std::vector<NamedSet> small_sets() {
  std::vector<NamedSet> sets;
  const auto add = [&sets](std::string name, std::vector<Point3> points) {
    sets.push_back({std::move(name), std::move(points)});
  };
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const std::string s = ", seed " + std::to_string(seed);
    const std::size_t n = 5 + 9 * seed;
    add("box of " + std::to_string(n) + s, point_sets::uniform_cube(n, seed));
    add("lattice of side 3" + s, point_sets::random_lattice(n + 10, 3, seed));
    add("lattice of side 5" + s, point_sets::random_lattice(n + 10, 5, seed));
    add("clusters of " + std::to_string(n) + s, point_sets::clusters(n, seed));
    add("bumpy sphere of " + std::to_string(n) + s, point_sets::bumpy_sphere(n, seed));
  }
  for (const long squared_radius : {1L, 3L, 5L, 9L, 14L}) {
    const std::string name = "lattice sphere " + std::to_string(squared_radius);
    auto sphere = point_sets::lattice_sphere(squared_radius);
    add(name, sphere);
    sphere.push_back({0, 0, 0});
    add(name + " and its centre", sphere);
  }
  add("grid of side 3", point_sets::grid(3));
  add("grid of side 4", point_sets::grid(4));
  return sets;
}

std::vector<NamedSet> bodies() {
  const auto ball = point_sets::sphere(0.3, 1);
  return {{"sphere 0.2, seed 1", point_sets::sphere(0.2, 1)},
          {"ellipsoid 0.13, seed 2", point_sets::ellipsoid(0.13, 2)},
          {"cube 0.12, seed 3", point_sets::cube_surface(0.12, 3)},
          {"torus 0.2, seed 3", point_sets::torus(0.2, 3)},
          {"double torus 0.1, seed 1", point_sets::double_torus(0.1, 1)},
          {"random torus of 300, seed 4", point_sets::random_torus(300, 4)},
          {"two spheres", point_sets::joined(ball, point_sets::translated(ball, {3, 0, 0}))}};
}

std::vector<Point3> set_with_hidden_point() {
  return {{8, 10, 14},          {10, 14, 14},         {1002, 1005, 259}, {1, 8, 11},
          {1015, 1006, 255},    {6, 14, 10},          {1003, 1005, 254}, {3012, 9001, 6756},
          {5010, 25002, 31254}, {4001, 16008, 16002}, {1003, 1008, 264}, {3003, 9011, 6763},
          {2006, 4014, 2015}};
}

}  // namespace tetsculpt::testing
