// The paper's figures again, from real runs of its method: pictures with captions, for
// bench/report.py.
//   build/release/bench/bench_figures FOLDER [POINTS_FILE ...]
// Of each file: how many 3-cycles of EGH edges are no triangle of the Delaunay complex.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/album.h"
#include "bench/dumbbell.h"
#include "bench/inputs.h"
#include "bench/paper_stages.h"
#include "bench/surface_measures.h"
#include "sculpt/reconstruct.h"
#include "support/point_sets.h"

namespace tetsculpt::bench {
namespace {

constexpr Colour kTree{200, 40, 30};
constexpr Colour kBlue{40, 90, 200};
constexpr Colour kGreen{30, 130, 70};
constexpr Colour kOrange{240, 150, 40};

/// Looks along a direction, from its head.
View view_along(const Point3& p) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  View view;
  view.azimuth = std::atan2(p.y, p.x) * kDegrees;
  view.elevation = std::atan2(p.z, std::hypot(p.x, p.y)) * kDegrees;
  return view;
}

Segments segments(const PaperStages& stages, const std::vector<EdgeId>& edges, Colour colour) {
  Segments result;
  result.colour = colour;
  for (const EdgeId e : edges) {
    const auto [a, b] = stages.complex.vertices(e);
    result.ends.push_back({stages.distinct.points[+a], stages.distinct.points[+b]});
  }
  return result;
}

std::vector<EdgeId> flagged(const Flags& flags) {
  std::vector<EdgeId> edges;
  for (std::uint32_t e = 0; e < flags.size(); ++e) {
    if (flags[e]) edges.push_back(EdgeId{e});
  }
  return edges;
}

/// Figures 1 and 2: the graphs, in front of the surface so that their far sides do not show.
void draw_graphs(Album& album) {
  const std::vector<Point3> points = point_sets::torus(0.09, 1);
  const PaperStages stages = paper_stages(points);
  const TriangleMesh surface = reconstruct(points).mesh;
  const auto draw = [&](const char* name, const std::vector<EdgeId>& edges, Colour colour,
                        const std::string& what) {
    Scene scene;
    scene.mesh = &surface;
    scene.face_colours.assign(surface.triangles.size(), {245, 245, 245});
    scene.segments.push_back(segments(stages, edges, colour));
    album.add("1 and 2: graphs", name, scene, {},
              what + ", " + std::to_string(edges.size()) + " edges on " +
                  std::to_string(points.size()) + " points of a torus");
  };
  draw("emst", stages.tree, kTree, "Euclidean minimum spanning tree");
  draw("gabriel", flagged(stages.gabriel), kBlue, "Gabriel graph");
  draw("egh", flagged(stages.egh.edges), kGreen, "Extended Gabriel hypergraph");
}

/// Without the triangles that have a corner farther than `radius` from a place.
void keep_near(TriangleMesh& mesh, const Point3& centre, double radius) {
  std::erase_if(mesh.triangles, [&](const std::array<std::uint32_t, 3>& t) {
    return std::ranges::any_of(t, [&](std::uint32_t v) {
      const Point3& p = mesh.points[v];
      return std::hypot(p.x - centre.x, p.y - centre.y, p.z - centre.z) >= radius;
    });
  });
}

/// Puts all points that no triangle uses where one is that some triangle does: they no longer count
/// for the size of a picture.
void gather_unused(TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return;
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto& t : mesh.triangles) used[t[0]] = used[t[1]] = used[t[2]] = true;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) mesh.points[v] = mesh.points[mesh.triangles[0][0]];
  }
}

/// Takes the triangles over a hidden vertex away and returns them.
TriangleMesh opened_over(TriangleMesh& mesh, const PaperStages& stages, VertexId hidden) {
  std::set<std::array<std::uint32_t, 3>> opposite;  // the facets of its star, corners ascending
  for (std::uint32_t t = 0; t < stages.complex.finite_tet_count(); ++t) {
    const auto& v = stages.complex.vertices(TetId{t});
    const auto at = std::ranges::find(v, hidden);
    if (at == v.end()) continue;
    const auto& f = kFacetCorners[static_cast<std::size_t>(at - v.begin())];
    auto corners = indices({v[f[0]], v[f[1]], v[f[2]]});
    std::ranges::sort(corners);
    opposite.insert(corners);
  }
  TriangleMesh cover;
  cover.points = mesh.points;
  std::erase_if(mesh.triangles, [&](std::array<std::uint32_t, 3> t) {
    const auto triangle = t;
    std::ranges::sort(t);
    if (!opposite.contains(t)) return false;
    cover.triangles.push_back(triangle);
    return true;
  });
  return cover;
}

Segments outline(const TriangleMesh& mesh, Colour colour) {
  Segments lines;
  lines.colour = colour;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      lines.ends.push_back({mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]});
    }
  }
  return lines;
}

/// The surface around a hidden vertex, with what covers it, and opened there.
void draw_covered(Album& album, const PaperStages& stages, TriangleMesh surface,
                  const TriangleMesh& cover, VertexId v, const std::string& caption) {
  const Point3& place = stages.distinct.points[+v];
  keep_near(surface, place, 0.4);
  // Through the middle of the first triangle that covers it.
  const auto& [a, b, c] = cover.triangles.front();
  const View view =
      view_along({(cover.points[a].x + cover.points[b].x + cover.points[c].x) / 3 - place.x,
                  (cover.points[a].y + cover.points[b].y + cover.points[c].y) / 3 - place.y,
                  (cover.points[a].z + cover.points[b].z + cover.points[c].z) / 3 - place.z});
  gather_unused(surface);
  Scene opened;
  opened.mesh = &surface;
  opened.segments.push_back(outline(surface, {120, 120, 120}));
  opened.dots.push_back({{place}, kTree, 5});
  TriangleMesh covered = surface;
  Scene closed;
  closed.face_colours.assign(surface.triangles.size(), {190, 200, 215});
  closed.face_colours.insert(closed.face_colours.end(), cover.triangles.size(), kOrange);
  covered.triangles.insert(covered.triangles.end(), cover.triangles.begin(), cover.triangles.end());
  covered.points = cover.points;
  gather_unused(covered);
  closed.mesh = &covered;
  closed.segments.push_back(outline(covered, {120, 120, 120}));
  album.add("3: a hidden vertex", "hidden_covered", closed, view, caption);
  album.add("3: a hidden vertex", "hidden_opened", opened, view,
            "The same without the orange triangles: the hidden vertex below them (red)");
}

/// Figure 3: a vertex that the EGH keeps inside, under the boundary triangles that cover it.
void draw_hidden_vertex(Album& album) {
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    const PaperStages stages = paper_stages(point_sets::bumpy_sphere(1500, seed));
    const HiddenByConstraints hidden = hidden_by_constraints(stages);
    for (const VertexId v : hidden.vertices) {
      TriangleMesh surface = surface_after(stages, hidden.removed);
      const TriangleMesh cover = opened_over(surface, stages, v);
      if (cover.triangles.empty()) continue;
      draw_covered(album, stages, std::move(surface), cover, v,
                   "Bumpy sphere of 1500 points, seed " + std::to_string(seed) + ": " +
                       std::to_string(hidden.vertices.size()) +
                       " hidden where no tetrahedron may go that EMST or EGH hold. One lies under "
                       "the orange triangles");
      return;
    }
  }
  album.note("3: a hidden vertex", "none of 49 samples of a bumpy sphere had one");
}

/// The faces of tetrahedra, as a mesh.
TriangleMesh faces_of(const PaperStages& stages, std::span<const TetId> tets) {
  TriangleMesh mesh;
  mesh.points.assign(stages.distinct.points.begin(), stages.distinct.points.end());
  for (const TetId t : tets) {
    const auto& v = stages.complex.vertices(t);
    for (const auto& f : kFacetCorners) {
      mesh.triangles.push_back(indices({v[f[0]], v[f[1]], v[f[2]]}));
    }
  }
  gather_unused(mesh);
  return mesh;
}

/// Figures 4 and 5: a pseudo-prism in a torus, and the hole it opens.
void draw_hole(Album& album) {
  const PaperStages stages = paper_stages(point_sets::torus(0.12, 1));
  const Sculpture& sculpture = stages.sculpture;
  if (sculpture.holes.empty()) return album.note("4: a pseudo-prism", "the torus got no hole");
  const std::size_t at = sculpture.holes.front();
  const std::span<const TetId> prism = std::span(sculpture.removed).subspan(at, 3);
  View above;
  above.elevation = 55;

  const TriangleMesh before = surface_after(stages, at);
  const TriangleMesh faces = faces_of(stages, prism);
  Scene scene;
  scene.mesh = &before;
  scene.segments.push_back(outline(faces, kTree));
  album.add("4: a pseudo-prism", "prism_place", scene, above,
            "A torus, its hole still filled, and where the pseudo-prism is (red)");
  Scene alone;
  alone.mesh = &faces;
  alone.face_colours.assign(faces.triangles.size(), kOrange);
  alone.segments.push_back(outline(faces, kTree));
  album.add("4: a pseudo-prism", "prism", alone, {}, "The three tetrahedra of the pseudo-prism");

  const std::size_t end =
      sculpture.holes.size() > 1 ? sculpture.holes[1] : sculpture.removed.size();
  const std::array<std::size_t, 4> moments{at, at + 3, at + 3 + (end - at - 3) / 3, end};
  for (std::size_t k = 0; k < moments.size(); ++k) {
    const TriangleMesh surface = surface_after(stages, moments[k]);
    Scene moment;
    moment.mesh = &surface;
    album.add("5: a hole is made", "hole_" + std::to_string(k), moment, above,
              std::to_string(moments[k]) + " tetrahedra removed, genus " +
                  std::to_string(topology(surface).genus));
  }
  album.note("5: a hole is made",
             "At the end: genus " +
                 std::to_string(topology(surface_after(stages, sculpture.removed.size())).genus) +
                 ", " + std::to_string(sculpture.holes.size()) + " pseudo-prisms removed");
}

/// Figure 6: the four criteria and guided sculpting on one body.
void draw_criteria(Album& album) {
  const std::vector<Point3> points = dumbbell(0.12, 1);
  const PaperStages stages = paper_stages(points);
  struct Way {
    const char* name;
    const char* title;
    ReconstructOptions options;
  };
  const std::array<Way, 5> ways{
      {{"area", "minimal area change", {Method::kPaper, Criterion::kMinimalArea}},
       {"gamma", "gamma-indicator", {Method::kPaper, Criterion::kGamma}},
       {"longest", "longest edge, unconstrained", {Method::kPaper, Criterion::kLongestEdge}},
       {"constrained", "longest edge, constrained", {Method::kPaper, Criterion::kConstrained}},
       {"guided", "guided", {Method::kGuided}}}};
  for (const Way& way : ways) {
    const Reconstruction r = reconstruct(points, way.options);
    const DistanceToTruth distance = distance_to_truth(r.mesh, distance_to_dumbbell);
    Scene scene;
    scene.mesh = &r.mesh;
    scene.segments.push_back(outline(r.mesh, {110, 110, 110}));
    View side;
    side.azimuth = 250;
    std::array<char, 300> text{};
    std::snprintf(text.data(), text.size(),
                  "%s | %.3f | %.2e | %.3f | %zu of %zu | %zu | %zu | %zu", way.title,
                  surface_area(r.mesh) / dumbbell_area(), distance.mean, distance.largest,
                  sharp_triangles(r.mesh), r.mesh.triangles.size(), tree_edges_off(stages, r.mesh),
                  topology(r.mesh).genus, r.hidden.size());
    album.add("6: criteria", std::string("criterion_") + way.name, scene, side, text.data());
  }
}

void count_cycles(Album& album, const std::string& name, const std::vector<Point3>& points) {
  const PaperStages stages = paper_stages(points);
  const EghCycles found = egh_cycles(stages);
  album.note("cycles", name + " | " + std::to_string(points.size()) + " | " +
                           std::to_string(found.cycles) + " | " +
                           std::to_string(found.not_in_complex));
}

}  // namespace
}  // namespace tetsculpt::bench

int main(int argc, char** argv) try {
  using namespace tetsculpt;
  if (argc < 2) {
    std::cerr << "usage: bench_figures FOLDER [POINTS_FILE ...]\n";
    return 1;
  }
  bench::Album album(argv[1]);
  bench::draw_graphs(album);
  bench::draw_hidden_vertex(album);
  bench::draw_hole(album);
  bench::draw_criteria(album);
  bench::count_cycles(album, "bumpy sphere", point_sets::bumpy_sphere(20'000, 1));
  bench::count_cycles(album, "torus", point_sets::random_torus(20'000, 1));
  bench::count_cycles(album, "cube", point_sets::uniform_cube(20'000, 1));
  bench::count_cycles(album, "integer grid of side 16", point_sets::grid(16));
  for (int k = 2; k < argc; ++k) {
    const std::string file = argv[k];
    bench::count_cycles(album, file.substr(file.find_last_of('/') + 1),
                        bench::points_of_file(file));
  }
} catch (const std::exception& error) {
  std::cerr << "bench_figures: " << error.what() << '\n';
  return 1;
}
