// Legacy VTK files of polygons in both layouts and both forms.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/io_meshes.h"
#include "tests/support/io_ply_bytes.h"
#include "tests/support/meshes.h"

namespace tetsculpt {
namespace {

const std::vector<Point3> kSquare = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0.5}};
const testing::Triangles kFan = {{0, 1, 2}, {0, 2, 3}};
const std::string kAscii = "# vtk DataFile Version 3.0\nany title\nASCII\nDATASET POLYDATA\n";
const std::string kBinary = "# vtk DataFile Version 5.1\nany title\nBINARY\nDATASET POLYDATA\n";
const std::string kPoints = "POINTS 4 double\n0 0 0 2 0 0\n2 2\n0\n0 2 .5\n";

template <typename Number>
std::string big(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    text += testing::bytes(static_cast<Number>(value), std::endian::big);
  }
  return text + "\n";
}

Precision check_square(const std::string& content) {
  INFO(content);
  const MeshFile file = testing::mesh_from("a.vtk", content);
  CHECK(file.mesh.points == kSquare);
  CHECK(file.mesh.triangles == kFan);
  return file.precision;
}

TEST_CASE("ascii") {
  CHECK(check_square(kAscii + kPoints + "POLYGONS 1 5\n4 0 1 2 3\n") == Precision::kDouble);
  check_square(kAscii + kPoints + "POLYGONS 2 8 3 0 1 2 3 0\n2 3");
  check_square(kAscii + kPoints +
               "POLYGONS 2 4\nOFFSETS vtktypeint64\n0 4\n"
               "CONNECTIVITY vtktypeint64\n0 1 2 3\n");
  check_square(kAscii + "FIELD FieldData 1\ntime 1 2 double\n1 2\n" + kPoints +
               "METADATA\nINFORMATION 1\nNAME x LOCATION y\n\nVERTICES 1 2\n1 0\n"
               "LINES 1 3\n2 0 1\nPOLYGONS 2 8\n3 0 1 2\n3 0 2 3\nCELL_DATA 2\nanything\n");
}

TEST_CASE("binary") {
  const std::vector<double> xyz = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0.5};
  const std::string singles = kBinary + "POINTS 4 float\n" + big<float>(xyz);
  const std::string doubles = kBinary + "POINTS 4 double\n" + big<double>(xyz);
  const std::string polygons = "POLYGONS 2 8\n" + big<std::int32_t>({3, 0, 1, 2, 3, 0, 2, 3});
  CHECK(check_square(singles + polygons) == Precision::kSingle);
  CHECK(check_square(doubles + polygons) == Precision::kDouble);
  check_square(doubles + "LINES 1 3\n" + big<std::int32_t>({2, 0, 1}) + polygons +
               "POINT_DATA 4\n\1\2\3");
  check_square(doubles + "POLYGONS 3 6\nOFFSETS vtktypeint64\n" + big<std::int64_t>({0, 3, 6}) +
               "CONNECTIVITY vtktypeint64\n" + big<std::int64_t>({0, 1, 2, 0, 2, 3}));
  check_square(doubles + "METADATA\nINFORMATION 0\n\nLINES 2 2\nOFFSETS int\n" +
               big<std::int32_t>({0, 2}) + "CONNECTIVITY int\n" + big<std::int32_t>({1, 2}) +
               polygons);
}

TEST_CASE("refusals") {
  const auto refusal = [](const std::string& content) {
    return testing::mesh_refusal("a.vtk", content);
  };
  CHECK(refusal("ply\n") == "1: not a legacy VTK file");
  CHECK(refusal("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n") ==
        "4: a mesh has the dataset POLYDATA, not 'UNSTRUCTURED_GRID'");
  CHECK(refusal(kAscii) == "4: the file has no POINTS");
  CHECK(refusal(kAscii + kPoints) == "9: the file has no POLYGONS");
  CHECK(refusal(kAscii + kPoints + "POLYGONS 1 4\n3 0 1 4\n") == "11: a face names vertex 4 of 4");
  CHECK(refusal(kAscii + kPoints + "POLYGONS 1 4\n3 0 -1 4\n") ==
        "11: a face names vertex -1 of 4");
  CHECK(refusal(kAscii + kPoints + "POLYGONS 1 3\n2 0 1\n") ==
        "11: a face needs at least 3 corners, this one has 2");
  CHECK(refusal(kAscii + kPoints + "POLYGONS 1 5\n3 0 1 2\n") ==
        "11: the file ends within an array");
  CHECK(refusal(kAscii + kPoints + "POLYGONS 1 5\n3 0 1 2 3\n") ==
        "11: the polygons have fewer values than announced");
  CHECK(refusal(kAscii + kPoints + "POLYGONS 2 4\n3 0 1 2\n") ==
        "11: the polygons have more values than announced");
  CHECK(refusal(kAscii + kPoints + "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\n") ==
        "10: triangle strips are not read");
  CHECK(refusal(kAscii + kPoints + "POLYGONS 3 6\nOFFSETS int\n0 4 3\n") ==
        "12: offsets that do not ascend");
  CHECK(refusal(kBinary + "POINTS 4 float\n\1\2\3") ==
        "5: the file is too short for 4 times 3 numbers");
  CHECK(refusal(kAscii + "POINTS 4000000000 float\n0 0 0\n") ==
        "5: the file is too short for 4000000000 times 3 numbers");
  const std::string points = kBinary + "POINTS 1 char\n000\nPOLYGONS 1 4\n";
  CHECK(refusal(points + big<std::int32_t>({3, 0, 0, 1})) ==
        "byte " + std::to_string(points.size() + 16) + ": a face names vertex 1 of 1");
  CHECK(refusal(kAscii + kPoints + "POLYGONS 2 3\nOFFSETS int\n0 3\n1 2 3\n") ==
        "13: expected CONNECTIVITY");
  CHECK(refusal(kAscii + kPoints + "POLYGONS 2 3\nOFFSETS float\n0 3\n") ==
        "11: indices must be integers");
}

}  // namespace
}  // namespace tetsculpt
