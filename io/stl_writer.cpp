#include "io/stl_writer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "io/byte_order.h"
#include "io/float_coordinates.h"
#include "io/io_error.h"
#include "io/unit_vectors.h"

namespace tetsculpt {
namespace {

void check_limits(const TriangleMesh& mesh, const AtomicFile& out) {
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw IoError(out.name(), "an STL file cannot hold 2^32 triangles");
  }
  if (const std::optional<std::size_t> i = beyond_floats(mesh.points)) {
    throw IoError(out.name(),
                  "point " + std::to_string(*i) + " is too large for the floats of STL");
  }
}

char* store_floats(char* to, double x, double y, double z) {
  for (const double value : {x, y, z}) to = store_little_endian(to, static_cast<float>(value));
  return to;
}

}  // namespace

WriteReport write_stl(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      AtomicFile& out) {
  check_limits(mesh, out);
  // The first word must not be "solid": that begins an STL text.
  std::string header = "binary STL made by tetsculpt";
  header.resize(80, ' ');
  out.write(header);
  std::array<char, 4> count;
  store_little_endian(count.data(), static_cast<std::uint32_t>(mesh.triangles.size()));
  out.write({count.data(), count.size()});

  std::array<char, 50> bytes{};
  for (const auto& triangle : mesh.triangles) {
    const Point3& a = mesh.points[triangle[0]];
    const Point3& b = mesh.points[triangle[1]];
    const Point3& c = mesh.points[triangle[2]];
    const Vec3<double> normal = unit_normal(a, b, c);
    char* at = store_floats(bytes.data(), normal.x, normal.y, normal.z);
    for (const Point3* p : {&a, &b, &c}) at = store_floats(at, p->x, p->y, p->z);
    store_little_endian(at, std::uint16_t{0});
    out.write({bytes.data(), bytes.size()});
  }
  WriteReport report{.rounded = rounded_axes(mesh.points)};
  for (const Attribute& attribute : attributes) report.dropped.push_back(attribute.name);
  return report;
}

}  // namespace tetsculpt
