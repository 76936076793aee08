// A program of somebody else's: the installed library, its headers by the installed path.
#include <tetsculpt/io/write_mesh.h>
#include <tetsculpt/kernel/triangle_mesh.h>
#include <tetsculpt/sculpt/reconstruct.h>

#include <cstdio>
#include <vector>

int main() {
  const std::vector<tetsculpt::Point3> points{
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  tetsculpt::ReconstructOptions options;
  options.method = tetsculpt::Method::kPaper;
  const tetsculpt::Reconstruction result = tetsculpt::reconstruct(points, options);
  if (result.span != tetsculpt::Span::kSolid || tetsculpt::broken_invariant(result.mesh)) return 1;
  tetsculpt::write_mesh(result.mesh, "consumer.ply");
  std::printf("%zu triangles\n", result.mesh.triangles.size());
  return 0;
}
