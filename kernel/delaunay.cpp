#include "kernel/delaunay.h"

#include <utility>

#include "kernel/large_array.h"
#include "kernel/lifted_hull.h"

namespace tetsculpt {
namespace {

/// Of the work; the rest finds triangles and edges.
constexpr double kHullShare = 0.8;

}  // namespace

TetComplex delaunay(const DistinctPoints& points, const DelaunayOptions& options) {
  const LargeArrayReuse reuse;
  std::function<void(double)> progress;
  if (options.progress) progress = [&](double in) { options.progress(kHullShare * in); };
  LiftedHull hull = lifted_hull(points.points, {.threads = options.threads, .progress = progress});
  if (hull.tets.empty()) return {};
  if (progress) progress = [&](double in) { options.progress(kHullShare + (1 - kHullShare) * in); };
  return TetComplex(std::move(hull), points.points.size(), progress, options.threads);
}

}  // namespace tetsculpt
