#include "io/off_writer.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/attribute_groups.h"
#include "io/text_rows.h"

namespace tetsculpt {
namespace {

void add_colour(const AttributeRefs& colours, std::size_t i, TextRows& rows) {
  const bool bytes = std::holds_alternative<std::vector<std::uint8_t>>(colours[0]->values);
  for (const Attribute* colour : colours) {
    rows.add(" ");
    if (bytes) {
      rows.add_value(colour->values, i);
    } else {
      rows.add_fraction(colour->values, i);
    }
  }
  if (colours.size() == 3) rows.add(bytes ? " 255" : " 1.0");
}

}  // namespace

WriteReport write_off(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      AtomicFile& out) {
  const AttributeGroups groups = grouped(attributes);
  TextRows rows(out);
  if (!groups.colours.empty()) rows.add("C");
  if (!groups.normals.empty()) rows.add("N");
  rows.add("OFF\n# made by tetsculpt\n");
  rows.add_number(mesh.points.size());
  rows.add(" ");
  rows.add_number(mesh.triangles.size());
  rows.add(" 0\n");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    rows.add_point(mesh.points[i]);
    for (const Attribute* normal : groups.normals) {
      rows.add(" ");
      rows.add_value(normal->values, i);
    }
    if (!groups.colours.empty()) add_colour(groups.colours, i, rows);
    rows.add("\n");
  }
  rows.add_triangles(mesh.triangles, "3 ", 0, "\n");
  rows.finish();
  return {.dropped = names_of(groups.others)};
}

}  // namespace tetsculpt
