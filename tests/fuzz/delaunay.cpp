// The Delaunay complex of few small integer points keeps all its invariants, in either order of the
// points.
#include "kernel/delaunay.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/first_simplex.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/small_points.h"

namespace tetsculpt::fuzz {
namespace {

void run(std::vector<Point3> points) {
  const DistinctPoints distinct = distinct_points(points);
  require_none(broken_invariant(distinct, points));
  const TetComplex complex = delaunay(distinct);
  const bool solid = first_simplex(distinct.points).size == 4;
  require((complex.finite_tet_count() > 0) == solid, "tetrahedra without a solid, or none in one");
  if (!solid) return;
  require_none(broken_invariant(complex, distinct.points));
  std::ranges::reverse(points);
  const TetComplex again = delaunay(distinct_points(points));
  require(again.finite_tet_count() == complex.finite_tet_count(),
          "the order of the points matters");
}

}  // namespace
}  // namespace tetsculpt::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tetsculpt::fuzz::run(tetsculpt::fuzz::small_points({data, size}));
  return 0;
}
