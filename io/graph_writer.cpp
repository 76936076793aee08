#include "io/graph_writer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "io/atomic_file.h"
#include "io/byte_order.h"

namespace tetsculpt {
namespace {

std::string header(std::size_t points, const PointGraph& graph, Precision precision) {
  const std::string type = precision == Precision::kSingle ? "float" : "double";
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment made by tetsculpt\n";
  text += "element vertex " + std::to_string(points) + '\n';
  for (const char* axis : {"x", "y", "z"}) text += "property " + type + ' ' + axis + '\n';
  text += "element edge " + std::to_string(graph.edges.size()) +
          "\nproperty int vertex1\nproperty int vertex2\n";
  if (!graph.triangles.empty()) {
    text += "element face " + std::to_string(graph.triangles.size()) +
            "\nproperty list uchar int vertex_indices\n";
  }
  return text + "end_header\n";
}

template <typename Number>
void write_number(Number number, AtomicFile& out) {
  std::array<char, sizeof(Number)> bytes;
  store_little_endian(bytes.data(), number);
  out.write({bytes.data(), bytes.size()});
}

void write_point(const Point3& point, Precision precision, AtomicFile& out) {
  for (const double value : {point.x, point.y, point.z}) {
    if (precision == Precision::kSingle) {
      write_number(static_cast<float>(value), out);
    } else {
      write_number(value, out);
    }
  }
}

}  // namespace

void write_graph(std::span<const Point3> points, const PointGraph& graph, Precision precision,
                 const std::filesystem::path& path) {
  AtomicFile out(path);
  out.write(header(points.size(), graph, precision));
  for (const Point3& point : points) write_point(point, precision, out);
  for (const auto& edge : graph.edges) {
    for (const std::uint32_t end : edge) write_number(end, out);
  }
  for (const auto& triangle : graph.triangles) {
    write_number(std::uint8_t{3}, out);
    for (const std::uint32_t corner : triangle) write_number(corner, out);
  }
  out.commit();
}

}  // namespace tetsculpt
