#include "io/stl_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "io/byte_order.h"
#include "io/io_error.h"

namespace tetsculpt {
namespace {

using Vector = std::array<double, 3>;

Vector difference(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double largest(const Vector& v) {
  return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
}

// Divided by its largest component, so that no product over- or underflows; zero stays zero.
Vector scaled(const Vector& v) {
  const double scale = largest(v);
  if (scale == 0) return v;
  return {v[0] / scale, v[1] / scale, v[2] / scale};
}

Vector unit_normal(const Point3& a, const Point3& b, const Point3& c) {
  const Vector n = scaled(cross(scaled(difference(b, a)), scaled(difference(c, a))));
  const double length = std::hypot(n[0], n[1], n[2]);
  if (length == 0) return n;
  return {n[0] / length, n[1] / length, n[2] / length};
}

void check_limits(const TriangleMesh& mesh, const std::filesystem::path& path) {
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw IoError(path, "an STL file cannot hold 2^32 triangles");
  }
  constexpr double kLargest = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Point3& p = mesh.points[i];
    if (largest({p.x, p.y, p.z}) <= kLargest) continue;
    throw IoError(path, "point " + std::to_string(i) + " is too large for the floats of STL");
  }
}

char* store_floats(char* to, const Vector& values) {
  for (const double value : values) to = store_little_endian(to, static_cast<float>(value));
  return to;
}

}  // namespace

void write_stl(const TriangleMesh& mesh, const std::filesystem::path& path, AtomicFile& out) {
  check_limits(mesh, path);
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
    char* at = store_floats(bytes.data(), unit_normal(a, b, c));
    for (const Point3* p : {&a, &b, &c}) at = store_floats(at, {p->x, p->y, p->z});
    store_little_endian(at, std::uint16_t{0});
    out.write({bytes.data(), bytes.size()});
  }
}

}  // namespace tetsculpt
