// Legacy VTK: points and point data of ascii and binary files, whatever else is in them.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_ply_bytes.h"
#include "tests/support/io_point_attributes.h"

namespace tetsculpt {
namespace {

using testing::attribute_names;
using testing::has_values;
using testing::read_content;

std::string header(const std::string& format, const std::string& kind = "POLYDATA") {
  return "# vtk DataFile Version 3.0\na title\n" + format + "\nDATASET " + kind + "\n";
}

template <typename Number>
std::string big(const std::vector<Number>& values) {
  std::string all;
  for (const Number value : values) all += testing::bytes(value, std::endian::big);
  return all;
}

const std::vector<Point3> kPoints = {{1, 2, 3}, {4, 5, 6}};

TEST_CASE("ascii: kinds of data sets and types of points") {
  for (const char* kind : {"POLYDATA", "UNSTRUCTURED_GRID", "STRUCTURED_GRID\nDIMENSIONS 2 1 1"}) {
    CAPTURE(kind);
    CHECK(
        read_content("a.vtk", header("ASCII", kind) + "POINTS 2 float\n1 2 3 4\n5\n\n6\n").points ==
        kPoints);
  }
  const auto file = [](const std::string& type) {
    return read_content("a.vtk", header("ASCII") + "POINTS 1 " + type + "\n.1 2 3\n");
  };
  CHECK(file("float").precision == Precision::kSingle);
  CHECK(file("float").points[0].x == double{0.1F});
  CHECK(file("double").precision == Precision::kDouble);
  CHECK(file("double").points[0].x == 0.1);
}

TEST_CASE("binary: big endian, with bytes that look like line ends") {
  const std::string data = big<double>({1, 2, 3, 4, 5, 6});
  CHECK(read_content("a.vtk", header("BINARY") + "POINTS 2 double\n" + data).points == kPoints);
  const PointFile odd = read_content(
      "a.vtk", header("BINARY") + "POINTS 1 float\n" + std::string(12, '\n') + "\nLINES 0 0\n");
  CHECK(odd.points[0].x == double{std::bit_cast<float>(std::uint32_t{0x0A0A0A0A})});
  CHECK(read_content("a.vtk", header("BINARY") + "POINTS 2 short\n" +
                                  big<std::int16_t>({1, 2, 3, 4, 5, 6}) + "\n")
            .points == kPoints);
}

TEST_CASE("ascii: every section") {
  const PointFile file = read_content(
      "a.vtk",
      header("ASCII") +
          "FIELD FieldData 1\nTIME 1 1 double\n0.5\nPOINTS 2 double\n1 2 3 4 5 6\n"
          "VERTICES 1 3\n2 0 1\nPOLYGONS 2 8\n3 0 1 1\n3 1 0 0\nCELL_DATA 3\n"
          "SCALARS c int 1\nLOOKUP_TABLE default\n7 8 9\nPOINT_DATA 2\n"
          "SCALARS Intensity unsigned_char\nLOOKUP_TABLE mine\n200 100\n"
          "LOOKUP_TABLE mine 2\n0 0 0 1 1 1 1 1\nSCALARS uv float 2\nLOOKUP_TABLE default\n"
          "1 2 3 4\nNORMALS n float\n0 0 1 0 1 0\nCOLOR_SCALARS paint 3\n1 0 0 0 .5 0\n"
          "VECTORS v double\n1 2 3 4 5 6\nTEXTURE_COORDINATES t 2 float\n0 0 1 1\n"
          "TENSORS T float\n1 2 3\n4 5 6\n7 8 9\n\n1 2 3\n4 5 6\n7 8 9\n"
          "FIELD more 2\ntemperature 1 2 short\n-1 2\nMETADATA\nINFORMATION 0\n\n"
          "flags 1 2 bit\n0 1\n");
  CHECK(file.points == kPoints);
  CHECK(attribute_names(file) ==
        "intensity uv_0 uv_1 nx ny nz red green blue v_0 v_1 v_2 t_0 t_1 T_0 T_1 T_2 T_3 T_4 T_5 "
        "T_6 T_7 T_8 temperature");
  CHECK(has_values<std::uint8_t>(file, "intensity", {200, 100}));
  CHECK(has_values<float>(file, "uv_1", {2, 4}));
  CHECK(has_values<float>(file, "ny", {0, 1}));
  CHECK(has_values<double>(file, "green", {0, 0.5}));
  CHECK(has_values<double>(file, "v_2", {3, 6}));
  CHECK(has_values<std::int16_t>(file, "temperature", {-1, 2}));
}

TEST_CASE("binary: every section") {
  const PointFile file = read_content(
      "a.vtk", header("BINARY", "UNSTRUCTURED_GRID") + "POINTS 2 float\n" +
                   big<float>({1, 2, 3, 4, 5, 6}) + "\nCELLS 1 3\n" + big<std::int32_t>({2, 0, 1}) +
                   "\nCELL_TYPES 1\n" + big<std::int32_t>({3}) +
                   "\nCELL_DATA 9\nSCALARS c bit\nLOOKUP_TABLE default\n\n\n" +
                   "\nPOINT_DATA 2\nCOLOR_SCALARS paint 4\n" +
                   big<std::uint8_t>({10, 13, 0, 1, 5, 6, 7, 8}) + "\nSCALARS id long\n" +
                   "LOOKUP_TABLE default\n" + big<std::int64_t>({-1, 1LL << 40}) +
                   "\nLOOKUP_TABLE table 1\n\n\n\n\n\nFIELD f 1\nw 1 2 double\n" +
                   big<double>({0.1, 0.2}) + "\n");
  CHECK(file.points == kPoints);
  CHECK(file.precision == Precision::kSingle);
  CHECK(attribute_names(file) == "red green blue alpha id w");
  CHECK(has_values<std::uint8_t>(file, "green", {13, 6}));
  CHECK(has_values<double>(file, "id", {-1, 0x1p40}));
  CHECK(has_values<double>(file, "w", {0.1, 0.2}));
}

TEST_CASE("cells of version 5") {
  for (const bool is_binary : {false, true}) {
    const std::string file =
        header(is_binary ? "BINARY" : "ASCII") + "POINTS 2 float\n" +
        (is_binary ? big<float>({1, 2, 3, 4, 5, 6}) : "1 2 3 4 5 6") +
        "\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n" + (is_binary ? big<std::int64_t>({0, 3}) : "0 3") +
        "\nCONNECTIVITY vtktypeint64\n" + (is_binary ? big<std::int64_t>({0, 1, 0}) : "0 1 0") +
        "\nPOINT_DATA 2\nSCALARS s int\n" + "LOOKUP_TABLE default\n" +
        (is_binary ? big<std::int32_t>({7, 8}) : "7 8") + "\n";
    CHECK(has_values<std::int32_t>(read_content("a.vtk", file), "s", {7, 8}));
  }
}

TEST_CASE("an attribute called x") {
  const PointFile file =
      read_content("a.vtk", header("ASCII") +
                                "POINTS 1 float\n1 2 3\nPOINT_DATA 1\nSCALARS x float\n"
                                "LOOKUP_TABLE default\n9\n");
  CHECK(attribute_names(file) == "x_2");
}

}  // namespace
}  // namespace tetsculpt
