#include "io/obj_writer.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "io/attribute_groups.h"
#include "io/text_rows.h"

namespace tetsculpt {
namespace {

void add_vertices(const TriangleMesh& mesh, const AttributeGroups& groups, TextRows& rows) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    rows.add("v ");
    rows.add_point(mesh.points[i]);
    for (const Attribute* colour : groups.colours) {
      rows.add(" ");
      rows.add_share(colour->values, i);
    }
    rows.add("\n");
  }
  if (groups.normals.empty()) return;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    rows.add("vn");
    for (const Attribute* normal : groups.normals) {
      rows.add(" ");
      rows.add_value(normal->values, i);
    }
    rows.add("\n");
  }
}

void add_faces_with_normals(const TriangleMesh& mesh, TextRows& rows) {
  for (const auto& triangle : mesh.triangles) {
    rows.add("f");
    for (const std::uint32_t corner : triangle) {
      const std::uint64_t index = std::uint64_t{corner} + 1;
      rows.add(" ");
      rows.add_number(index);
      rows.add("//");
      rows.add_number(index);
    }
    rows.add("\n");
  }
}

}  // namespace

WriteReport write_obj(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      AtomicFile& out) {
  AttributeGroups groups = grouped(attributes);
  drop_alpha(groups);
  TextRows rows(out);
  rows.add("# made by tetsculpt\n");
  add_vertices(mesh, groups, rows);
  if (groups.normals.empty()) {
    rows.add_triangles(mesh.triangles, "f ", 1, "\n");
  } else {
    add_faces_with_normals(mesh, rows);
  }
  rows.finish();
  return {.dropped = names_of(groups.others)};
}

}  // namespace tetsculpt
