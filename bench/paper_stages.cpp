#include "bench/paper_stages.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <iterator>

#include "kernel/delaunay.h"
#include "kernel/edge_order.h"
#include "kernel/emst.h"
#include "kernel/gabriel.h"
#include "kernel/large_array.h"
#include "sculpt/boundary.h"
#include "sculpt/exposure.h"

namespace tetsculpt::bench {
namespace {

bool in_egh(const PaperStages& stages, TetId t, const Exposure& e) {
  for (int i = 0; i < 4; ++i) {
    if (e.on_boundary(static_cast<std::size_t>(i)) &&
        stages.egh.triangles[+stages.complex.triangle(t, i)]) {
      return true;
    }
  }
  return false;
}

/// Does a stage's work and adds its time.
template <class Work>
void timed(PaperStages& stages, Stage stage, Work&& work) {
  const std::clock_t start = std::clock();
  work();
  stages.seconds[static_cast<std::size_t>(stage)] +=
      static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Per vertex, its neighbours in the EGH with larger ids, ascending.
std::vector<std::vector<VertexId>> larger_neighbors(const PaperStages& stages) {
  std::vector<std::vector<VertexId>> larger(stages.complex.vertex_count());
  for (std::uint32_t e = 0; e < stages.complex.edge_count(); ++e) {
    if (!stages.egh.edges[e]) continue;
    const auto [a, b] = stages.complex.vertices(EdgeId{e});
    larger[+a].push_back(b);
  }
  for (auto& list : larger) std::sort(list.begin(), list.end());
  return larger;
}

}  // namespace

PaperStages paper_stages(std::span<const Point3> points) {
  const LargeArrayReuse reuse;
  PaperStages stages;
  const auto& sites = stages.distinct.points;
  Constraints constraints;
  timed(stages, Stage::kDelaunay, [&] {
    stages.distinct = distinct_points(points);
    stages.complex = delaunay(stages.distinct);
  });
  timed(stages, Stage::kEgh, [&] {
    stages.gabriel = gabriel_edges(sites, stages.complex);
    stages.egh = extended_gabriel_hypergraph(sites, stages.complex, stages.gabriel);
  });
  timed(stages, Stage::kEmst, [&] {
    stages.tree = emst(stages.complex, edges_by_length(sites, stages.complex, stages.gabriel));
    constraints.emst_edges.assign(stages.complex.edge_count(), 0);
    for (const EdgeId e : stages.tree) constraints.emst_edges[+e] = 1;
  });
  constraints.egh_triangles = stages.egh.triangles;
  timed(stages, Stage::kSculpt, [&] {
    stages.sculpture = sculpt_paper(sites, stages.complex, constraints);
    stages.surface = boundary_triangles(stages.complex, stages.sculpture.solid);
  });
  return stages;
}

std::array<std::uint32_t, 3> indices(const std::array<VertexId, 3>& corners) {
  std::array<std::uint32_t, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = static_cast<std::uint32_t>(+corners[i]);
  return result;
}

TriangleMesh surface_after(const PaperStages& stages, std::size_t count) {
  Flags solid(stages.complex.tet_count(), 0);
  std::fill_n(solid.begin(), stages.complex.finite_tet_count(), std::uint8_t{1});
  for (std::size_t k = 0; k < count; ++k) solid[+stages.sculpture.removed[k]] = 0;
  TriangleMesh mesh;
  mesh.points.assign(stages.distinct.points.begin(), stages.distinct.points.end());
  for (const auto& corners : boundary_triangles(stages.complex, solid)) {
    mesh.triangles.push_back(indices(corners));
  }
  return mesh;
}

HiddenByConstraints hidden_by_constraints(const PaperStages& stages) {
  Boundary boundary(stages.complex);
  std::size_t k = 0;
  // The first removal through a triangle of the EGH is the end of the constrained step.
  for (; k < stages.sculpture.removed.size(); ++k) {
    const TetId t = stages.sculpture.removed[k];
    if (in_egh(stages, t, exposure(boundary, t))) break;
    boundary.remove(t);
  }
  return {boundary.hidden_vertices(), k};
}

EghCycles egh_cycles(const PaperStages& stages) {
  const auto larger = larger_neighbors(stages);
  EghCycles found;
  for (const auto& list : larger) {
    for (const VertexId b : list) {
      std::vector<VertexId> common;
      std::set_intersection(list.begin(), list.end(), larger[+b].begin(), larger[+b].end(),
                            std::back_inserter(common));
      found.cycles += common.size();
    }
  }
  // Every triangle of the complex with three such edges is one of these cycles.
  std::size_t in_complex = 0;
  for (const std::uint8_t flag : stages.egh.triangles) in_complex += flag;
  found.not_in_complex = found.cycles - in_complex;
  return found;
}

}  // namespace tetsculpt::bench
