#include "sculpt/reconstruct.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "kernel/delaunay.h"
#include "kernel/emst.h"
#include "kernel/first_simplex.h"
#include "kernel/gabriel.h"
#include "kernel/large_array.h"
#include "sculpt/record.h"
#include "sculpt/sculpt_guided.h"
#include "sculpt/sculpt_paper.h"

namespace tetsculpt {
namespace {

class Stopwatch {
 public:
  /// Seconds since the last lap or the start.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// A stage's own progress callback, empty if the caller gave none.
std::function<void(double)> stage_progress(const ReconstructOptions& options,
                                           std::string_view stage) {
  if (!options.progress) return {};
  options.progress(stage, 0);
  return [&options, stage](double done) { options.progress(stage, done); };
}

std::size_t count(const Flags& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

bool tells_story(const ReconstructOptions& options) {
  return options.record == ReconstructOptions::Record::kStory;
}

/// The graphs. Guided sculpting needs no edges of the EMST, only their number, which is known.
Constraints constraints(std::span<const Point3> points, const TetComplex& complex,
                        const ReconstructOptions& options, Reconstruction::Counts& counts) {
  const Flags gabriel = gabriel_edges(points, complex, options.threads);
  Egh egh = extended_gabriel_hypergraph(points, complex, gabriel);
  counts.gabriel_edges = count(gabriel);
  counts.emst_edges = points.size() - 1;
  counts.egh_edges = count(egh.edges);
  counts.egh_triangles = count(egh.triangles);
  Constraints result{std::move(egh.triangles), {}};
  if (options.method == Method::kPaper || tells_story(options)) {
    result.emst_edges.assign(complex.edge_count(), 0);
    for (const EdgeId e : emst(complex, edges_by_length(points, complex, gabriel))) {
      result.emst_edges[+e] = 1;
    }
  }
  return result;
}

Sculpture sculpt(std::span<const Point3> points, const TetComplex& complex,
                 const Constraints& held_back, const ReconstructOptions& options) {
  const auto progress = stage_progress(options, "sculpt");
  if (options.method == Method::kGuided) {
    using Keep = GuidedOptions::Keep;
    return sculpt_guided(
        points, complex, held_back.egh_triangles,
        {.progress = progress, .keep = tells_story(options) ? Keep::kLabels : Keep::kSolid});
  }
  return sculpt_paper(points, complex, held_back,
                      {.criterion = options.criterion, .progress = progress});
}

/// Renumbers a surface over vertex ids to the order of the input and fills in the rest.
void write_mesh(std::span<const Point3> input, const DistinctPoints& distinct,
                const TetComplex& complex, const Sculpture& sculpture, Reconstruction& out) {
  std::vector<std::uint32_t> index(distinct.points.size(), 0);
  for (const VertexId v : sculpture.hidden) {
    index[+v] = Reconstruction::kHidden;
    out.hidden.push_back(distinct.first_input[+v]);
  }
  std::sort(out.hidden.begin(), out.hidden.end());
  out.vertex_of_input.resize(input.size());
  out.mesh.points.reserve(index.size() - sculpture.hidden.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    const VertexId v = distinct.vertex_of_input[i];
    if (distinct.first_input[+v] == i && index[+v] != Reconstruction::kHidden) {
      index[+v] = static_cast<std::uint32_t>(out.mesh.points.size());
      out.mesh.points.push_back(input[i]);
    }
    out.vertex_of_input[i] = index[+v];
  }
  const auto triangles = boundary_triangles(complex, sculpture.solid);
  out.mesh.triangles.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    out.mesh.triangles.push_back({index[+a], index[+b], index[+c]});
  }
}

/// Per vertex, its index in a Reconstruction::Story.
std::vector<std::uint32_t> story_indices(const DistinctPoints& distinct,
                                         const Reconstruction& out) {
  std::vector<std::uint32_t> index;
  index.reserve(distinct.first_input.size());
  for (const std::uint32_t i : distinct.first_input) {
    const auto rank = std::lower_bound(out.hidden.begin(), out.hidden.end(), i);
    const auto after_mesh =
        out.mesh.points.size() + static_cast<std::size_t>(std::distance(out.hidden.begin(), rank));
    index.push_back(out.vertex_of_input[i] == Reconstruction::kHidden
                        ? static_cast<std::uint32_t>(after_mesh)
                        : out.vertex_of_input[i]);
  }
  return index;
}

/// The record and the graphs, over the vertices of `out`.
Reconstruction::Story story(const DistinctPoints& distinct, const TetComplex& complex,
                            const Constraints& graphs, const Sculpture& sculpture,
                            const Reconstruction& out) {
  const std::vector<std::uint32_t> index = story_indices(distinct, out);
  Reconstruction::Story told;
  told.record = sculpting_record(complex, sculpting_steps(complex, sculpture));
  for (auto& triangle : told.record.triangles) {
    for (std::uint32_t& v : triangle) v = index[v];
  }
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    if (!graphs.emst_edges[e]) continue;
    const auto& [a, b] = complex.vertices(EdgeId{e});
    told.emst_edges.push_back({index[+a], index[+b]});
  }
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    if (!graphs.egh_triangles[t]) continue;
    const auto& [a, b, c] = complex.vertices(TriangleId{t});
    told.egh_triangles.push_back({index[+a], index[+b], index[+c]});
  }
  return told;
}

}  // namespace

Reconstruction reconstruct(std::span<const Point3> points, const ReconstructOptions& options) {
  const LargeArrayReuse reuse;
  Reconstruction out;
  Stopwatch watch;
  const DistinctPoints distinct = distinct_points(points);
  const TetComplex complex = delaunay(
      distinct, {.threads = options.threads, .progress = stage_progress(options, "delaunay")});
  out.counts.vertices = distinct.points.size();
  out.counts.tetrahedra = complex.finite_tet_count();
  out.seconds.delaunay = watch.lap();
  out.span = complex.tet_count() > 0 ? Span::kSolid
                                     : static_cast<Span>(first_simplex(distinct.points).size);
  if (out.span != Span::kSolid) return out;

  stage_progress(options, "graphs");
  const Constraints held_back = constraints(distinct.points, complex, options, out.counts);
  out.seconds.graphs = watch.lap();

  const Sculpture sculpture = sculpt(distinct.points, complex, held_back, options);
  out.counts.holes = sculpture.holes.size();
  write_mesh(points, distinct, complex, sculpture, out);
  if (tells_story(options)) out.story = story(distinct, complex, held_back, sculpture, out);
  out.seconds.sculpt = watch.lap();
  return out;
}

}  // namespace tetsculpt
