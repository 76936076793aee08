#include "io/obj_writer.h"

#include "io/text_rows.h"

namespace tetsculpt {

void write_obj(const TriangleMesh& mesh, AtomicFile& out) {
  out.write("# made by tetsculpt\n");
  for (const Point3& point : mesh.points) write_point_row(out, "v ", point);
  for (const auto& triangle : mesh.triangles) write_index_row(out, "f ", triangle, 1, "\n");
}

}  // namespace tetsculpt
