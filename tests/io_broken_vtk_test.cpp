// Broken VTK files, and data sets without a list of points, are refused with the place.
#include <doctest/doctest.h>

#include <bit>
#include <string>

#include "tests/support/io_files.h"

namespace tetsculpt {
namespace {

using testing::refusal;

const std::string kBegin = "# vtk DataFile Version 3.0\ntitle\n";
const std::string kAscii = kBegin + "ASCII\nDATASET POLYDATA\n";
const std::string kBinary = kBegin + "BINARY\nDATASET POLYDATA\n";
const std::string kPoint = "POINTS 1 float\n1 2 3\n";

std::string refused(const std::string& text) { return refusal("a.vtk", text); }

TEST_CASE("header") {
  CHECK(refused("") == "1: not a legacy VTK file");
  CHECK(refused("POINTS 1 float\n") == "1: not a legacy VTK file");
  CHECK(refused(kBegin) == "2: the file ends within its header");
  CHECK(refused(kBegin + "TEXT\n") == "3: expected ASCII or BINARY");
  CHECK(refused(kAscii) == "4: the file has no POINTS");
  CHECK(refused(kBegin + "ASCII\nDATASET STRUCTURED_POINTS\n") ==
        "4: DATASET 'STRUCTURED_POINTS' has no list of points; POLYDATA, UNSTRUCTURED_GRID and "
        "STRUCTURED_GRID are read");
  CHECK(refused(kBegin + "ASCII\nDATASET RECTILINEAR_GRID\n").starts_with("4: DATASET 'RECTI"));
}

TEST_CASE("sections") {
  CHECK(refused(kAscii + kPoint + kPoint) == "7: a second section POINTS");
  CHECK(refused(kAscii + kPoint + "COLOURS a float\n") == "7: not a section of a VTK file");
  CHECK(refused(kAscii + "POINTS 1 string\na b c\n") == "5: arrays of type 'string' are not read");
  CHECK(refused(kAscii + "POINTS 1 bit\n0 0 1\n") == "5: points of type bit");
  CHECK(refused(kAscii + kPoint + "POINT_DATA 2\n") == "7: data of 2 points; the file has 1");
  CHECK(refused(kAscii + kPoint + "POINT_DATA 1\nFIELD f 1\na 1 2 float\n1 2\n") ==
        "9: an array of 2 values for 1 points");
  CHECK(refused(kAscii + kPoint + "POINT_DATA 1\nFIELD f 2\na 1 1 float\n1\n") ==
        "10: the file ends within a FIELD");
  CHECK(refused(kAscii + kPoint + "POINT_DATA 1\nSCALARS s float 0\nLOOKUP_TABLE d\n") ==
        "9: an array of 0 components");
  CHECK(refused(kAscii + kPoint + "POINT_DATA 1\nFIELD f 1\na 1000000000 1 float\n") ==
        "9: an array of 1000000000 components");
}

TEST_CASE("ascii arrays") {
  CHECK(refused(kAscii + "POINTS 2 float\n1 2 3 4 5         \n") ==
        "6: the file ends within an array");
  CHECK(refused(kAscii + "POINTS 1 float\n1 2 x\n") == "6: expected a number, found 'x'");
  CHECK(refused(kAscii + "POINTS 1 float\n1 2 1e39\n") == "6: number out of range: '1e39'");
  CHECK(refused(kAscii + "POINTS 1000000000000000000 float\n1 2 3\n") ==
        "5: the file is too short for 1000000000000000000 times 3 numbers");
  CHECK(refused(kAscii + "POINTS 18446744073709551615 float\n1 2 3\n") ==
        "5: the file is too short for 18446744073709551615 times 3 numbers");
  CHECK(refused(kAscii + kPoint + "POLYGONS 1 9000000000000000000\n3 0 0 0\n") ==
        "7: the file is too short for 9000000000000000000 times 1 numbers");
  CHECK(refused(kAscii + kPoint + "POINT_DATA 1\nSCALARS s char\nLOOKUP_TABLE d\n128\n") ==
        "10: expected a whole number from -128 to 127");
}

TEST_CASE("binary arrays: the place is a byte behind the first") {
  CHECK(refused(kBinary + "POINTS 1 float\n" + std::string(11, '\0')) ==
        "5: the file is too short for 1 times 3 numbers");
  const std::string begin = kBinary + "POINTS 1 float\n" + std::string(12, '\0') + "\n";
  const std::string keyword = "POLYGONS 1 4";
  CHECK(refused(begin + keyword + "\n" + std::string(15, '\0')) ==
        "byte " + std::to_string(begin.size() + keyword.size()) +
            ": the file is too short for 4 times 1 numbers");
  CHECK(refused(begin + "NONSENSE a") ==
        "byte " + std::to_string(begin.size() + 10) + ": not a section of a VTK file");
}

}  // namespace
}  // namespace tetsculpt
