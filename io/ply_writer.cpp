#include "io/ply_writer.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "io/byte_order.h"

namespace tetsculpt {
namespace {

std::string header(const TriangleMesh& mesh, Precision precision) {
  const std::string type = precision == Precision::kSingle ? "float" : "double";
  // Same bits, but an index of 2^31 or more is not to be read as a negative one.
  const bool fits_int = mesh.points.size() <= std::numeric_limits<std::int32_t>::max();
  return "ply\n"
         "format binary_little_endian 1.0\n"
         "comment made by tetsculpt\n"
         "element vertex " +
         std::to_string(mesh.points.size()) + "\nproperty " + type + " x\nproperty " + type +
         " y\nproperty " + type + " z\nelement face " + std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar " + (fits_int ? "int" : "uint") +
         " vertex_indices\n"
         "end_header\n";
}

template <typename Float>
void write_points(const TriangleMesh& mesh, AtomicFile& out) {
  std::array<char, 3 * sizeof(Float)> bytes;
  for (const Point3& point : mesh.points) {
    char* at = bytes.data();
    for (const double value : {point.x, point.y, point.z}) {
      const auto rounded = static_cast<Float>(value);
      assert(static_cast<double>(rounded) == value || std::isnan(value));
      at = store_little_endian(at, rounded);
    }
    out.write({bytes.data(), bytes.size()});
  }
}

void write_faces(const TriangleMesh& mesh, AtomicFile& out) {
  std::array<char, 1 + 3 * sizeof(std::uint32_t)> bytes;
  for (const auto& triangle : mesh.triangles) {
    char* at = store_little_endian(bytes.data(), std::uint8_t{3});
    for (const std::uint32_t corner : triangle) at = store_little_endian(at, corner);
    out.write({bytes.data(), bytes.size()});
  }
}

}  // namespace

void write_ply(const TriangleMesh& mesh, Precision precision, AtomicFile& out) {
  out.write(header(mesh, precision));
  if (precision == Precision::kSingle) {
    write_points<float>(mesh, out);
  } else {
    write_points<double>(mesh, out);
  }
  write_faces(mesh, out);
}

}  // namespace tetsculpt
