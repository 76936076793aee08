// What is written reads back bit for bit.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "io/read_points.h"
#include "io/write_mesh.h"
#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"

namespace tetsculpt {
namespace {

using testing::hard_numbers;
using testing::points_of;
using testing::random_bit_patterns;
using testing::same_bits;
using testing::TempDir;

constexpr std::uint64_t kSeed = 20240611;
constexpr std::size_t kPatterns = 10'000;

PointFile written_and_read(const std::vector<Point3>& points, const std::string& name,
                           Precision precision, PlyEncoding ply_encoding = PlyEncoding::kBinary) {
  const TempDir dir;
  TriangleMesh mesh{points, {}};
  if (points.size() >= 3) mesh.triangles = {{0, 1, 2}, {2, 1, 0}};
  write_mesh(mesh, dir.path() / name, {.precision = precision, .ply_encoding = ply_encoding});
  return read_points(dir.path() / name);
}

void check_doubles(const std::vector<Point3>& points) {
  for (const char* name : {"mesh.ply", "mesh.obj", "mesh.off", "MESH.PLY", "mesh.Obj"}) {
    CAPTURE(name);
    const PointFile file = written_and_read(points, name, Precision::kDouble);
    CHECK(same_bits(file.points, points));
    CHECK(file.precision == Precision::kDouble);
  }
  CHECK(same_bits(
      written_and_read(points, "mesh.ply", Precision::kDouble, PlyEncoding::kAscii).points,
      points));
}

void check_floats(const std::vector<Point3>& points) {
  for (const std::string name : {"mesh.ply", "mesh.obj", "mesh.off"}) {
    CAPTURE(name);
    const PointFile file = written_and_read(points, name, Precision::kSingle);
    CHECK(same_bits(file.points, points));
    const bool has_floats = name == "mesh.ply";
    CHECK(file.precision == (has_floats ? Precision::kSingle : Precision::kDouble));
  }
  CHECK(same_bits(
      written_and_read(points, "mesh.ply", Precision::kSingle, PlyEncoding::kAscii).points,
      points));
}

TEST_CASE("no points") {
  check_doubles({});
  check_floats({});
}

TEST_CASE("zeros, neighbours, denormals, the largest") {
  check_doubles(points_of(hard_numbers<double>()));
  check_floats(points_of(hard_numbers<float>()));
}

TEST_CASE("random bit patterns") {
  CAPTURE(kSeed);
  check_doubles(points_of(random_bit_patterns<double, std::uint64_t>(kPatterns, kSeed)));
  check_floats(points_of(random_bit_patterns<float, std::uint32_t>(kPatterns, kSeed)));
}

TEST_CASE("a file larger than a block of the writer") {
  const auto some = points_of(random_bit_patterns<double, std::uint64_t>(100'000, kSeed + 1));
  CHECK(same_bits(written_and_read(some, "mesh.ply", Precision::kDouble).points, some));
  CHECK(same_bits(written_and_read(some, "mesh.off", Precision::kDouble).points, some));
}

}  // namespace
}  // namespace tetsculpt
