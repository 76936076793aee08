#include "sculpt/reconstruct.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "kernel/delaunay.h"
#include "kernel/egh.h"
#include "kernel/emst.h"
#include "kernel/first_simplex.h"
#include "kernel/gabriel.h"
#include "kernel/large_array.h"
#include "sculpt/boundary.h"
#include "sculpt/kept.h"
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

/// The graphs as flags. The EMST is there for the paper's method or to be kept: guided sculpting
/// needs no edges of it, only their number, which is known.
struct Graphs {
  Flags gabriel;
  Flags egh_edges;
  Constraints held_back;
};

Graphs graphs(std::span<const Point3> points, const TetComplex& complex,
              const ReconstructOptions& options) {
  const auto progress = stage_progress(options, "graphs");
  const auto told = [&](double done) {
    if (progress) progress(done);
  };
  Graphs out;
  out.gabriel = gabriel_edges(points, complex, options.threads);
  told(0.5);
  Egh egh = extended_gabriel_hypergraph(points, complex, out.gabriel);
  out.egh_edges = std::move(egh.edges);
  out.held_back.egh_triangles = std::move(egh.triangles);
  told(0.8);
  if (options.method == Method::kPaper || options.keep.graphs) {
    out.held_back.emst_edges.assign(complex.edge_count(), 0);
    for (const EdgeId e : emst(complex, edges_by_length(points, complex, out.gabriel))) {
      out.held_back.emst_edges[+e] = 1;
    }
  }
  told(1);
  return out;
}

void count_graphs(const Graphs& graphs, Reconstruction::Counts& counts) {
  counts.gabriel_edges = count(graphs.gabriel);
  counts.emst_edges = counts.vertices - 1;
  counts.egh_edges = count(graphs.egh_edges);
  counts.egh_triangles = count(graphs.held_back.egh_triangles);
}

Sculpture sculpt(std::span<const Point3> points, const TetComplex& complex, const Graphs& graphs,
                 const ReconstructOptions& options) {
  const auto progress = stage_progress(options, "sculpt");
  if (options.method == Method::kGuided) {
    using Keep = GuidedOptions::Keep;
    return sculpt_guided(
        points, complex, graphs.held_back.egh_triangles,
        {.progress = progress, .keep = options.keep.record ? Keep::kLabels : Keep::kSolid});
  }
  return sculpt_paper(points, complex, graphs.held_back,
                      {.criterion = options.criterion, .progress = progress});
}

/// Renumbers a surface over vertex ids to the order of the input and fills in the rest. Returns the
/// new number of each vertex; those of hidden ones follow.
std::vector<std::uint32_t> write_mesh(std::span<const Point3> input, const DistinctPoints& distinct,
                                      const TetComplex& complex, const Sculpture& sculpture,
                                      Reconstruction& out) {
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
  for (std::size_t k = 0; k < out.hidden.size(); ++k) {
    const VertexId v = distinct.vertex_of_input[out.hidden[k]];
    index[+v] = static_cast<std::uint32_t>(out.mesh.points.size() + k);
  }
  return index;
}

/// Fills in what is asked for besides the surface.
void keep(std::span<const Point3> input, const TetComplex& complex, const Graphs& graphs,
          const Sculpture& sculpture, std::span<const std::uint32_t> index, const Keep& kept,
          Reconstruction& out) {
  std::vector<Point3> points = out.mesh.points;
  for (const std::size_t i : out.hidden) points.push_back(input[i]);
  if (kept.graphs) {
    out.graphs.points = points;
    out.graphs.emst = kept_edges(complex, graphs.held_back.emst_edges, index);
    out.graphs.gabriel = kept_edges(complex, graphs.gabriel, index);
    out.graphs.egh =
        kept_hypergraph(complex, graphs.egh_edges, graphs.held_back.egh_triangles, index);
  }
  if (kept.record) {
    out.record = sculpting_record(complex, sculpting_steps(complex, sculpture));
    for (auto& triangle : out.record.triangles) {
      for (std::uint32_t& v : triangle) v = index[v];
    }
  }
  if (kept.tetrahedra) {
    out.tetrahedra = kept_tetrahedra(complex, sculpture.solid, index);
    out.tetrahedra.points = std::move(points);
  }
}

}  // namespace

Reconstruction reconstruct(std::span<const Point3> points, const ReconstructOptions& options) {
  const LargeArrayReuse reuse;
  Reconstruction out;
  Stopwatch watch;
  const DistinctPoints distinct = distinct_points(points, options.threads);
  const TetComplex complex = delaunay(
      distinct, {.threads = options.threads, .progress = stage_progress(options, "delaunay")});
  out.counts.vertices = distinct.points.size();
  out.counts.tetrahedra = complex.finite_tet_count();
  out.seconds.delaunay = watch.lap();
  out.span = complex.tet_count() > 0 ? Span::kSolid
                                     : static_cast<Span>(first_simplex(distinct.points).size);
  if (out.span != Span::kSolid) return out;

  Graphs known = graphs(distinct.points, complex, options);
  count_graphs(known, out.counts);
  if (!options.keep.graphs) known.gabriel = known.egh_edges = Flags();
  out.seconds.graphs = watch.lap();

  const Sculpture sculpture = sculpt(distinct.points, complex, known, options);
  out.counts.holes = sculpture.holes.size();
  const auto index = write_mesh(points, distinct, complex, sculpture, out);
  if (options.keep.graphs || options.keep.tetrahedra || options.keep.record) {
    keep(points, complex, known, sculpture, index, options.keep, out);
  }
  out.seconds.sculpt = watch.lap();
  return out;
}

}  // namespace tetsculpt
