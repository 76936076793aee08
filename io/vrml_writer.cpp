#include "io/vrml_writer.h"

#include <cstddef>
#include <string_view>

#include "io/attribute_groups.h"
#include "io/text_rows.h"

namespace tetsculpt {
namespace {

void begin_list(std::string_view node, std::string_view field, TextRows& rows) {
  rows.add("    ");
  rows.add(node);
  rows.add(" {\n      ");
  rows.add(field);
  rows.add(" [\n");
}

void end_list(TextRows& rows) { rows.add("      ]\n    }\n"); }

void add_vectors(const AttributeRefs& components, std::size_t count, TextRows& rows) {
  for (std::size_t i = 0; i < count; ++i) {
    std::string_view separator = "";
    for (const Attribute* component : components) {
      rows.add(separator);
      rows.add_share(component->values, i);
      separator = " ";
    }
    rows.add("\n");
  }
}

}  // namespace

WriteReport write_vrml(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                       AtomicFile& out) {
  AttributeGroups groups = grouped(attributes);
  drop_alpha(groups);
  TextRows rows(out);
  rows.add(
      "#VRML V2.0 utf8\n"
      "# made by tetsculpt\n"
      "Shape {\n"
      "  appearance Appearance { material Material { } }\n"
      "  geometry IndexedFaceSet {\n"
      "    ccw TRUE\n"
      "    solid TRUE\n");
  begin_list("coord Coordinate", "point", rows);
  for (const Point3& point : mesh.points) {
    rows.add_point(point);
    rows.add("\n");
  }
  end_list(rows);
  if (!groups.colours.empty()) {
    begin_list("color Color", "color", rows);
    add_vectors(groups.colours, mesh.points.size(), rows);
    end_list(rows);
  }
  if (!groups.normals.empty()) {
    begin_list("normal Normal", "vector", rows);
    add_vectors(groups.normals, mesh.points.size(), rows);
    end_list(rows);
  }
  rows.add("    coordIndex [\n");
  rows.add_triangles(mesh.triangles, "", 0, " -1\n");
  rows.add(
      "    ]\n"
      "  }\n"
      "}\n");
  rows.finish();
  return {.dropped = names_of(groups.others)};
}

}  // namespace tetsculpt
