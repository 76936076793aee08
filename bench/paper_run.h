#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "bench/paper_stages.h"
#include "kernel/point.h"
#include "sculpt/sculpture.h"

/// One reconstruction by the paper's method, in numbers.
namespace tetsculpt::bench {

struct PaperRun {
  std::array<double, kStageNames.size()> seconds{};  ///< see bench/paper_stages.h
  std::size_t points = 0;                            ///< distinct ones
  std::size_t tetrahedra = 0;
  std::size_t triangles = 0;  ///< of the surface
  std::size_t removed = 0;
  std::size_t holes = 0;   ///< opened by pseudo-prisms
  std::size_t hidden = 0;  ///< points that are not on the surface
  Sculpture::Work work;

  double total_seconds() const;
  /// By the surface's Euler number; the method makes one shell.
  std::size_t genus() const { return (triangles + 4 - 2 * (points - hidden)) / 4; }
};

/// Precondition: the points span a solid.
PaperRun run_paper(std::span<const Point3> points);

/// One for several of the same points: for each stage the median of its times.
/// Precondition: there are some.
PaperRun typical(std::span<const PaperRun> runs);

}  // namespace tetsculpt::bench
