#include "io/off_writer.h"

#include <string>

#include "io/text_rows.h"

namespace tetsculpt {

void write_off(const TriangleMesh& mesh, AtomicFile& out) {
  out.write("OFF\n# made by tetsculpt\n");
  out.write(std::to_string(mesh.points.size()) + " " + std::to_string(mesh.triangles.size()) +
            " 0\n");
  for (const Point3& point : mesh.points) write_point_row(out, "", point);
  for (const auto& triangle : mesh.triangles) write_index_row(out, "3 ", triangle, 0, "\n");
}

}  // namespace tetsculpt
