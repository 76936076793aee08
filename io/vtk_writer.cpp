#include "io/vtk_writer.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>

#include "io/attribute_groups.h"
#include "io/byte_order.h"
#include "io/io_error.h"
#include "io/number_columns.h"

namespace tetsculpt {
namespace {

constexpr std::endian kOrder = std::endian::big;  // of every legacy file
constexpr std::int32_t kTetrahedron = 10;         // VTK_TETRA

// In the order of AttributeValues.
constexpr std::array<std::string_view, 8> kTypes = {
    "char", "unsigned_char", "short", "unsigned_short", "int", "unsigned_int", "float", "double"};
static_assert(kTypes.size() == std::variant_size_v<AttributeValues>);

std::string line(std::string_view word, std::size_t count, std::string_view last = "") {
  std::string text = std::string(word).append(" ").append(std::to_string(count));
  if (!last.empty()) text.append(" ").append(last);
  return text.append("\n");
}

void write_head(std::string_view data_set, AtomicFile& out) {
  out.write("# vtk DataFile Version 3.0\nmade by tetsculpt\nBINARY\nDATASET ");
  out.write(data_set);
  out.write("\n");
}

template <typename Float>
void write_points(std::span<const Point3> points, AtomicFile& out) {
  out.write(line("POINTS", points.size(), sizeof(Float) == sizeof(float) ? "float" : "double"));
  std::string bytes;
  in_pieces(points.size(), [&](RowRange rows) {
    bytes.resize(rows.count * 3 * sizeof(Float));
    char* at = bytes.data();
    for (const Point3& p : points.subspan(rows.first, rows.count)) {
      for (const double value : {p.x, p.y, p.z}) {
        at = store_number(at, static_cast<Float>(value), kOrder);
      }
    }
    out.write(bytes);
  });
  out.write("\n");
}

// Each cell is the number of its corners and their indices.
template <std::size_t kCorners>
void write_cells(std::string_view word, std::span<const std::array<std::uint32_t, kCorners>> cells,
                 AtomicFile& out) {
  out.write(line(word, cells.size(), std::to_string((kCorners + 1) * cells.size())));
  std::string bytes;
  in_pieces(cells.size(), [&](RowRange rows) {
    bytes.resize(rows.count * (kCorners + 1) * sizeof(std::uint32_t));
    char* at = bytes.data();
    for (const auto& cell : cells.subspan(rows.first, rows.count)) {
      at = store_number(at, static_cast<std::uint32_t>(kCorners), kOrder);
      for (const std::uint32_t corner : cell) at = store_number(at, corner, kOrder);
    }
    out.write(bytes);
  });
  out.write("\n");
}

void write_array(const AttributeValues& values, std::size_t count, AtomicFile& out) {
  const std::size_t size = value_size(values);
  std::string bytes;
  in_pieces(count, [&](RowRange rows) {
    bytes.resize(rows.count * size);
    store_values(bytes.data(), size, rows, kOrder, values);
    out.write(bytes);
  });
  out.write("\n");
}

void write_scalars(const Attribute& attribute, std::size_t count, AtomicFile& out) {
  out.write(std::string("SCALARS ").append(attribute.name).append(" "));
  out.write(kTypes[attribute.values.index()]);
  out.write(" 1\nLOOKUP_TABLE default\n");
  write_array(attribute.values, count, out);
}

void check_indices(std::size_t points, const AtomicFile& out) {
  if (points > std::numeric_limits<std::int32_t>::max()) {
    throw IoError(out.name(), "a legacy VTK file cannot index 2^31 points");
  }
}

}  // namespace

WriteReport write_vtk(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      Precision precision, AtomicFile& out) {
  check_indices(mesh.points.size(), out);
  write_head("POLYDATA", out);
  if (precision == Precision::kSingle) {
    write_points<float>(mesh.points, out);
  } else {
    write_points<double>(mesh.points, out);
  }
  write_cells<3>("POLYGONS", mesh.triangles, out);
  WriteReport report;
  const AttributeRefs kept = nameable(refs_to(attributes), {}, report.dropped);
  if (!kept.empty()) out.write(line("POINT_DATA", mesh.points.size()));
  for (const Attribute* attribute : kept) write_scalars(*attribute, mesh.points.size(), out);
  return report;
}

void write_vtk(const TetMesh& mesh, AtomicFile& out) {
  check_indices(mesh.points.size(), out);
  write_head("UNSTRUCTURED_GRID", out);
  write_points<double>(mesh.points, out);
  write_cells<4>("CELLS", mesh.tetrahedra, out);
  const std::size_t count = mesh.tetrahedra.size();
  out.write(line("CELL_TYPES", count));
  write_array(std::vector<std::int32_t>(count, kTetrahedron), count, out);
  out.write(line("CELL_DATA", count));
  write_scalars({"inside", mesh.inside}, count, out);
}

}  // namespace tetsculpt
