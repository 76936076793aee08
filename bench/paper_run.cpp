#include "bench/paper_run.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace tetsculpt::bench {

double PaperRun::total_seconds() const {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

PaperRun run_paper(std::span<const Point3> input) {
  const PaperStages stages = paper_stages(input);
  return {.seconds = stages.seconds,
          .points = stages.distinct.points.size(),
          .tetrahedra = stages.complex.finite_tet_count(),
          .triangles = stages.surface.size(),
          .removed = stages.sculpture.removed.size(),
          .holes = stages.sculpture.holes.size(),
          .hidden = stages.sculpture.hidden.size(),
          .work = stages.sculpture.work};
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
