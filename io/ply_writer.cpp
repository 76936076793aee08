#include "io/ply_writer.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

#include "io/attribute_groups.h"
#include "io/byte_order.h"
#include "io/number_columns.h"
#include "io/text_rows.h"

namespace tetsculpt {
namespace {

constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
// In the order of AttributeValues.
constexpr std::array<std::string_view, 8> kTypes = {"char", "uchar", "short", "ushort",
                                                    "int",  "uint",  "float", "double"};
static_assert(kTypes.size() == std::variant_size_v<AttributeValues>);

std::string property(std::string_view type, std::string_view name) {
  return std::string("property ").append(type).append(" ").append(name).append("\n");
}

std::string header(const TriangleMesh& mesh, const AttributeRefs& attributes,
                   const PlyOptions& options) {
  const bool ascii = options.encoding == PlyEncoding::kAscii;
  const std::string_view type = options.precision == Precision::kSingle ? "float" : "double";
  // Same bits, but an index of 2^31 or more is not to be read as a negative one.
  const bool fits_int = mesh.points.size() <= std::numeric_limits<std::int32_t>::max();
  std::string text = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") +
                     " 1.0\ncomment made by tetsculpt\nelement vertex " +
                     std::to_string(mesh.points.size()) + "\n";
  for (const std::string_view axis : kAxes) text += property(type, axis);
  for (const Attribute* attribute : attributes) {
    text += property(kTypes[attribute->values.index()], attribute->name);
  }
  text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  text += property(fits_int ? "list uchar int" : "list uchar uint", "vertex_indices");
  return text + "end_header\n";
}

template <typename Float>
char* store_float(char* to, double value) {
  const auto rounded = static_cast<Float>(value);
  assert(static_cast<double>(rounded) == value || std::isnan(value));
  return store_little_endian(to, rounded);
}

template <typename Float>
void write_vertices(const TriangleMesh& mesh, const AttributeRefs& attributes, AtomicFile& out) {
  std::size_t stride = 3 * sizeof(Float);
  for (const Attribute* attribute : attributes) stride += value_size(attribute->values);
  std::string bytes;
  in_pieces(mesh.points.size(), [&](RowRange rows) {
    bytes.resize(rows.count * stride);
    char* row = bytes.data();
    for (std::size_t i = rows.first; i < rows.first + rows.count; ++i, row += stride) {
      const Point3& p = mesh.points[i];
      store_float<Float>(store_float<Float>(store_float<Float>(row, p.x), p.y), p.z);
    }
    char* column = bytes.data() + 3 * sizeof(Float);
    for (const Attribute* attribute : attributes) {
      store_values(column, stride, rows, std::endian::little, attribute->values);
      column += value_size(attribute->values);
    }
    out.write(bytes);
  });
}

void write_faces(const TriangleMesh& mesh, AtomicFile& out) {
  constexpr std::size_t kStride = 1 + 3 * sizeof(std::uint32_t);
  std::string bytes;
  in_pieces(mesh.triangles.size(), [&](RowRange rows) {
    bytes.resize(rows.count * kStride);
    char* at = bytes.data();
    for (std::size_t i = rows.first; i < rows.first + rows.count; ++i) {
      at = store_little_endian(at, std::uint8_t{3});
      for (const std::uint32_t corner : mesh.triangles[i]) at = store_little_endian(at, corner);
    }
    out.write(bytes);
  });
}

void write_ascii_body(const TriangleMesh& mesh, const AttributeRefs& attributes, AtomicFile& out) {
  TextRows rows(out);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    rows.add_point(mesh.points[i]);
    for (const Attribute* attribute : attributes) {
      rows.add(" ");
      rows.add_value(attribute->values, i);
    }
    rows.add("\n");
  }
  rows.add_triangles(mesh.triangles, "3 ", 0, "\n");
  rows.finish();
}

}  // namespace

WriteReport write_ply(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      const PlyOptions& options, AtomicFile& out) {
  WriteReport report;
  const AttributeRefs kept = nameable(refs_to(attributes), kAxes, report.dropped);
  out.write(header(mesh, kept, options));
  if (options.encoding == PlyEncoding::kAscii) {
    write_ascii_body(mesh, kept, out);
    return report;
  }
  if (options.precision == Precision::kSingle) {
    write_vertices<float>(mesh, kept, out);
  } else {
    write_vertices<double>(mesh, kept, out);
  }
  write_faces(mesh, out);
  return report;
}

}  // namespace tetsculpt
