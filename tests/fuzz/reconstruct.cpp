// The surface through few small integer points keeps what the library promises, by both methods.
#include "sculpt/reconstruct.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/mesh_points.h"
#include "kernel/mesh_report.h"
#include "kernel/mesh_shape.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/small_points.h"

namespace tetsculpt::fuzz {
namespace {

void run(const std::vector<Point3>& points, Method method) {
  const Reconstruction result = reconstruct(points, {.method = method});
  if (result.span != Span::kSolid) {
    require(result.mesh.triangles.empty(), "a surface of what is no solid");
    return;
  }
  require_none(broken_invariant(result.mesh));
  const MeshReport report = judge(result.mesh);
  require(report.closed() && report.unused_points.count == 0, "open, or with points left over");
  const PointsOnMesh on_mesh = compare_points(result.mesh, report, points);
  require(on_mesh.invented.count == 0, "an invented vertex");
  require(on_mesh.missing.count == result.hidden.size(), "a point that is missing and not named");
  require(method == Method::kPaper || result.hidden.empty(), "a hidden point");
  require(measure(result.mesh, report).flat_triangles.count == 0, "a flat triangle");
}

}  // namespace
}  // namespace tetsculpt::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<tetsculpt::Point3> points = tetsculpt::fuzz::small_points({data, size});
  tetsculpt::fuzz::run(points, tetsculpt::Method::kGuided);
  tetsculpt::fuzz::run(points, tetsculpt::Method::kPaper);
  return 0;
}
