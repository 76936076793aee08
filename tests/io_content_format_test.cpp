// What a file is: the format told, else the mark in its content, else its extension, else its
// looks.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/io_error.h"
#include "io/read_points.h"
#include "tests/support/io_files.h"
#include "tests/support/io_las_bytes.h"

namespace tetsculpt {
namespace {

using namespace std::string_view_literals;
using testing::refusal;

// Each has the one point 1, 2, 3, STL files have it three times.
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
    "property float z\nend_header\n1 2 3\n";
const std::string kOff = "OFF\n1 0 0\n1 2 3\n";
const std::string kStl =
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 1 2 3\nvertex 1 2 3\nendloop\n"
    "endfacet\nendsolid\n";
const std::string kPcd =
    "# .PCD v0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n";
const std::string kVtk =
    "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n1 2 3\n";
const std::string kText = "1 2 3\n";
const std::string kObj = "# by hand\no thing\nv 1 2 3\n";

std::string las() {
  testing::Las las;
  las.short_count = 1;
  las.records = testing::las_record(20, {1, 2, 3});
  return testing::las_bytes(las);
}

std::string binary_stl() {
  std::string file = "solid" + std::string(75, ' ');
  file += testing::bytes(std::uint32_t{1}, std::endian::little) + std::string(12, '\0');
  for (int i = 0; i < 3; ++i) {
    for (const float value : {1.0F, 2.0F, 3.0F}) {
      file += testing::bytes(value, std::endian::little);
    }
  }
  return file + std::string(2, '\0');
}

bool read_as(const std::string& path, std::string_view content, ReadPointsOptions options = {}) {
  const PointFile file = parse_points(content, path, options);
  return !file.points.empty() && file.points.front() == Point3{1, 2, 3};
}

TEST_CASE("the content's mark counts more than the extension") {
  for (const std::string& content : {kPly, kOff, kStl, kPcd, kVtk, las(), binary_stl()}) {
    CAPTURE(content.substr(0, 10));
    for (const char* path : {"a.ply", "a.xyz", "a.obj", "a.las", "a.stl", "a.txt", "a.json", "a"}) {
      CAPTURE(path);
      CHECK(read_as(path, content));
    }
  }
  CHECK(read_as("a.xyz", "COFF 1 0 0\n1 2 3 0 0 0\n"));
  CHECK(read_as("a.xyz", "\xEF\xBB\xBFSTCNOFF1\r\n1 2 3\r\n"));
}

TEST_CASE("without a mark the extension counts") {
  CHECK(read_as("a.xyz", "OFFSET\n1 2 3\n"));
  CHECK(read_as("a.xyz", "solid rock\n1 2 3\n"));
  CHECK(read_as("a.xyz", "# vtk\n1 2 3\n"));
  CHECK(read_as("a.OBJ", kObj));
  CHECK(read_as("a.pcd", "VERSION .7\n" + kPcd.substr(kPcd.find("FIELDS"))));
  CHECK(refusal("a.ply", kText) == "1: not a PLY file");
  CHECK(refusal("a.las", kText) == "not a LAS file");
  CHECK(refusal("a.stl", kText) == "not an STL file");
  CHECK(refusal("a.xyz", kObj) == "3: expected a number, found 'v'");
}

TEST_CASE("without both the looks count") {
  for (const char* path : {"standard input", "a.scan", "points", ".xyz"}) {
    CAPTURE(path);
    CHECK(read_as(path, kText));
    CHECK(read_as(path, kObj));
    CHECK(read_as(path, "x,y,z\n1\n1,2,3\n"));
  }
  CHECK(refusal("a", "") ==
        "not a known kind of point file (known: .xyz .txt .csv .pts .asc .ply .obj .off .stl .pcd "
        ".las .vtk)");
  CHECK(refusal("a.json", "{ \"points\": [1, 2, 3] }\n").starts_with("not a known kind"));
  CHECK(refusal("a", std::string(5000, '\0')).starts_with("not a known kind"));
}

TEST_CASE("a format that is told is binding") {
  CHECK(read_as("a.ply", kText, {.format = PointFormat::kText}));
  CHECK(read_as("a.xyz", kObj, {.format = PointFormat::kObj}));
  CHECK(read_as("a.xyz", kPly, {.format = PointFormat::kPly}));
  CHECK_THROWS_AS(read_as("a.ply", kPly, {.format = PointFormat::kOff}), IoError);
  CHECK_THROWS_AS(read_as("a.ply", kPly, {.format = PointFormat::kPcd}), IoError);
}

TEST_CASE("files that are known but not read say what to do") {
  CHECK(refusal("a.ply.gz", "\x1F\x8B\x08\0"sv) ==
        "compressed with gzip: unzip it first, for example with gunzip");
  CHECK(refusal("a.xyz", "\x1F\x8B\x08\0"sv).find("gunzip") != std::string::npos);
  CHECK(refusal("a.zip", "PK\x03\x04...").find("unzip") != std::string::npos);
  CHECK(refusal("a.xyz", "BZh91AY&SY").find("bunzip2") != std::string::npos);
  CHECK(refusal("a.xz",
                "\xFD"
                "7zXZ\0"sv)
            .find("unxz") != std::string::npos);
  CHECK(refusal("a", "\x28\xB5\x2F\xFD").find("unzstd") != std::string::npos);
  CHECK(refusal("a.txt",
                "\xFF\xFE"
                "1\0 \0"sv)
            .find("UTF-8") != std::string::npos);
  CHECK(refusal("a.ply", "\x89PNG\r\n\x1A\n").find("picture") != std::string::npos);
  CHECK(refusal("a.ply", "<!DOCTYPE html>").find("web page") != std::string::npos);
  CHECK(refusal("a.e57", "ASTM-E57").find("E57") != std::string::npos);
  CHECK_THROWS_AS(read_as("a", "\x1F\x8B", {.format = PointFormat::kText}), IoError);
}

TEST_CASE("every name of a format") {
  for (const char* name : {"xyz", "txt", "csv", "asc"}) {
    CHECK(point_format_named(name) == PointFormat::kText);
  }
  CHECK(point_format_named("pts") == PointFormat::kPts);
  CHECK(point_format_of("a.LAS") == PointFormat::kLas);
  CHECK_FALSE(point_format_named("laz"));
  CHECK_FALSE(point_format_of("a."));
}

}  // namespace
}  // namespace tetsculpt
