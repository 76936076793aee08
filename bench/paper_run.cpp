#include "bench/paper_run.h"

#include <algorithm>
#include <ctime>
#include <numeric>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/emst.h"
#include "kernel/gabriel.h"
#include "kernel/large_array.h"
#include "sculpt/boundary.h"
#include "sculpt/sculpt_paper.h"

namespace tetsculpt::bench {
namespace {

/// Calls `work` and adds its time to the stage.
template <class Work>
auto timed(PaperRun& run, Stage stage, Work&& work) {
  const std::clock_t start = std::clock();
  auto result = work();
  run.seconds[static_cast<std::size_t>(stage)] +=
      static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return result;
}

}  // namespace

double PaperRun::total_seconds() const {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

PaperRun run_paper(std::span<const Point3> input) {
  const LargeArrayReuse reuse;
  PaperRun run;
  const DistinctPoints distinct =
      timed(run, Stage::kDelaunay, [&] { return distinct_points(input); });
  const std::span<const Point3> points = distinct.points;
  const TetComplex complex = timed(run, Stage::kDelaunay, [&] { return delaunay(distinct); });
  const Flags gabriel = timed(run, Stage::kEgh, [&] { return gabriel_edges(points, complex); });
  Constraints constraints;
  constraints.egh_triangles = timed(run, Stage::kEgh, [&] {
    return extended_gabriel_hypergraph(points, complex, gabriel).triangles;
  });
  constraints.emst_edges = timed(run, Stage::kEmst, [&] {
    Flags tree(complex.edge_count(), 0);
    for (const EdgeId e : emst(complex, edges_by_length(points, complex, gabriel))) tree[+e] = 1;
    return tree;
  });
  const Sculpture sculpture =
      timed(run, Stage::kSculpt, [&] { return sculpt_paper(points, complex, constraints); });
  run.triangles = timed(run, Stage::kSculpt, [&] {
                    return boundary_triangles(complex, sculpture.solid);
                  }).size();
  run.points = points.size();
  run.tetrahedra = complex.finite_tet_count();
  run.removed = sculpture.removed.size();
  run.holes = sculpture.holes.size();
  run.hidden = sculpture.hidden.size();
  run.work = sculpture.work;
  return run;
}

PaperRun typical(std::span<const PaperRun> runs) {
  PaperRun result = runs.front();
  for (std::size_t stage = 0; stage < result.seconds.size(); ++stage) {
    std::vector<double> seconds;
    for (const PaperRun& run : runs) seconds.push_back(run.seconds[stage]);
    const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
    std::nth_element(seconds.begin(), middle, seconds.end());
    result.seconds[stage] = *middle;
  }
  return result;
}

}  // namespace tetsculpt::bench
