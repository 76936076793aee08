#pragma once

#include <functional>
#include <span>
#include <vector>

#include "kernel/point.h"
#include "kernel/tet_complex.h"
#include "sculpt/constraints.h"
#include "sculpt/priority.h"
#include "sculpt/sculpture.h"

/// Sculpting as the paper has it.
namespace tetsculpt {

struct PaperOptions {
  Criterion criterion = Criterion::kConstrained;
  /// When the constrained loop ends. The paper stops it once every vertex is on the boundary, which
  /// leaves concavities filled where the sampling is fine; see the source.
  enum class Stop { kHeapEmpty, kAllExposed } stop = Stop::kHeapEmpty;
  /// Told now and then which share of the vertices is on the boundary, from 0 to 1. May throw: that
  /// cancels, and the exception passes through.
  std::function<void(double)> progress = {};
};

/// Takes tetrahedra off the Delaunay complex until its boundary is the surface. The boundary stays
/// a closed 2-manifold in one piece throughout; its Euler number is 2 - 2 holes. [Attene, Spagnuolo
/// 2000, section 3]  Cost: O(n log n) in the size of the complex.
Sculpture sculpt_paper(std::span<const Point3> points, const TetComplex& complex,
                       const Constraints& constraints, const PaperOptions& options = {});

}  // namespace tetsculpt
