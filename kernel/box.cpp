#include "kernel/box.h"

#include <cstddef>

#include "kernel/parallel.h"

namespace tetsculpt {

Box box_of(std::span<const Point3> points, int threads) {
  const auto box_of_range = [&](std::size_t begin, std::size_t end) {
    Box part;
    for (std::size_t i = begin; i < end; ++i) part.include(points[i]);
    return part;
  };
  Box box;
  const auto cuts = share_cuts(points.size(), threads);
  for (const Box& part : parallel_results(cuts, threads, box_of_range)) box.include_all(part);
  return box;
}

}  // namespace tetsculpt
