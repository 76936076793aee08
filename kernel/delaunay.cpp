#include "kernel/delaunay.h"

#include <utility>

#include "kernel/large_array.h"
#include "kernel/lifted_hull.h"

namespace tetsculpt {

TetComplex delaunay(const DistinctPoints& points, const DelaunayOptions& options) {
  const LargeArrayReuse reuse;
  LiftedHull hull =
      lifted_hull(points.points, {.threads = options.threads, .progress = options.progress});
  if (hull.tets.empty()) return {};
  return TetComplex(std::move(hull), points.points.size());
}

}  // namespace tetsculpt
