#include "io/vrml_writer.h"

#include "io/text_rows.h"

namespace tetsculpt {

void write_vrml(const TriangleMesh& mesh, AtomicFile& out) {
  out.write(
      "#VRML V2.0 utf8\n"
      "# made by tetsculpt\n"
      "Shape {\n"
      "  appearance Appearance { material Material { } }\n"
      "  geometry IndexedFaceSet {\n"
      "    ccw TRUE\n"
      "    solid TRUE\n"
      "    coord Coordinate {\n"
      "      point [\n");
  for (const Point3& point : mesh.points) write_point_row(out, "", point);
  out.write(
      "      ]\n"
      "    }\n"
      "    coordIndex [\n");
  for (const auto& triangle : mesh.triangles) write_index_row(out, "", triangle, 0, " -1\n");
  out.write(
      "    ]\n"
      "  }\n"
      "}\n");
}

}  // namespace tetsculpt
