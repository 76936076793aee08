// Texts: which columns are x, y and z, what the others are called, and which of them are kept.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_point_attributes.h"

namespace tetsculpt {
namespace {

using testing::attribute_names;
using testing::has_values;
using testing::read_content;
using testing::refusal;

const std::vector<Point3> kExpected = {{1, 2, 3}, {4, 5, 6}};

// The names of attributes of a text whose points are kExpected.
std::string names(std::string_view name, std::string_view text) {
  CAPTURE(text);
  const PointFile file = read_content(name, text);
  CHECK(file.points == kExpected);
  return attribute_names(file);
}

TEST_CASE("titles name columns, in any order") {
  CHECK(names("a.csv", "x,y,z,intensity\n1,2,3,0.5\n4,5,6,0.25\n") == "intensity");
  CHECK(names("a.csv", "Z;X;class;Y\n3;1;7;2\n6;4;8;5\n") == "class");
  CHECK(names("a.txt", "\"X\" \"Y\" \"Z\" \"Nx\"\n1 2 3 0\n4 5 6 1\n") == "nx");
  CHECK(names("a.csv", ",x,y,z\n0,1,2,3\n1,4,5,6\n") == "scalar_1");
  CHECK(names("a.csv", "name,x,y,z,\nP1,1,2,3,\n\"a, b\",4,5,6,\n") == "");
  CHECK(names("a.csv", "x,y,z,GPS Time\n1,2,3,9,8\n4,5,6,9,8\n") == "GPS_Time scalar_5");
  CHECK(names("a.txt", "X\tY\tZ\tGPS Time\n1\t2\t3\t9\n4\t5\t6\t9\n") == "GPS_Time");
}

TEST_CASE("titles without x, y and z name what is behind the coordinates") {
  CHECK(names("a.csv", "east,north,up,intensity\n1,2,3,9\n4,5,6,9\n") == "intensity");
  CHECK(names("a.csv", "made by hand\n1,2,3,9\n4,5,6,9\n") == "scalar_4");
  CHECK(refusal("a.csv", "id,a,b,x\n1,2,3,4\n") ==
        "2: the titles do not name x, y and z once each");
}

TEST_CASE("titles with blanks that could mean other columns") {
  CHECK(names("a.txt", "X Y Z GPS Time\n1 2 3 9\n4 5 6 9\n") == "scalar_4");
  CHECK(refusal("a.txt", "GPS Time X Y Z\n9 1 2 3\n") ==
        "2: the header names 5 columns, the row "
        "has 4");
}

TEST_CASE("a comment names columns if it fits the rows") {
  CHECK(names("a.asc", "//X Y Z R G B\n1 2 3 0 0 9\n4 5 6 0 7 0\n") == "red green blue");
  CHECK(names("a.asc", "//Rf Gf Bf X Y Z\n2\n0 0 1 1 2 3\n0 .5 0 4 5 6\n") == "red green blue");
  CHECK(names("a.xyz", "# x,y,z,I\n1 2 3 9\n4 5 6 9\n") == "I");
  CHECK(names("a.xyz", "# x y z of a scan\n1 2 3 9\n4 5 6 9\n") == "scalar_4");
  CHECK(names("a.xyz", "# from a to b\n1 2 3 8 9\n4 5 6 8 9\n") == "scalar_4 scalar_5");
  CHECK(names("a.xyz", "1 2 3 8\n# x y z a\n4 5 6 8\n") == "scalar_4");
}

TEST_CASE("pts") {
  CHECK(names("a.pts", "2\n1 2 3 -9\n4 5 6 9\n") == "intensity");
  CHECK(names("a.pts", "1 2 3 9 9 9\n4 5 6 9 9 9\n") == "red green blue");
  CHECK(names("a.PTS", "2\n1 2 3 -7 9 9 9\n4 5 6 7 9 9 9\n") == "intensity red green blue");
  CHECK(names("a.pts", "1 2 3 9 9\n4 5 6 9 9\n") == "scalar_4 scalar_5");
  CHECK(names("a.xyz", "2\n1 2 3 9 9 9\n4 5 6 9 9 9\n") == "scalar_4 scalar_5 scalar_6");
}

TEST_CASE("a column is kept if every row has a number in it") {
  CHECK(names("a.csv", "1,2,3,9,8\n4,5,6,,8\n") == "scalar_5");
  CHECK(names("a.csv", "1,2,3,9,8\n4,5,6\n") == "");
  CHECK(names("a.csv", "1,2,3\n4,5,6,8\n") == "");
  CHECK(names("a.xyz", "1 2 3 oak 8\n4 5 6 elm 8\n") == "scalar_5");
  CHECK(names("a.xyz", "1 2 3 8 # a\n4 5 6 9 // 7\n") == "scalar_4");
  CHECK(has_values<double>(read_content("a.xyz", "1 2 3 8e-1\n4 5 6 -9\n"), "scalar_4", {0.8, -9}));
  CHECK(refusal("a.xyz", "1 2 3 1e999\n") == "1: number out of range: '1e999'");
}

TEST_CASE("colours are integers if all of them are") {
  const auto colours = [](const std::string& first, const std::string& second) {
    return read_content("a.csv", "x,y,z,r,g,b\n1,2,3," + first + "\n4,5,6," + second + "\n");
  };
  CHECK(has_values<std::uint8_t>(colours("0,0,255", "1,2,3"), "blue", {255, 3}));
  CHECK(has_values<std::uint16_t>(colours("0,0,256", "1,2,3"), "red", {0, 1}));
  CHECK(has_values<double>(colours("0,0,65536", "1,2,3"), "red", {0, 1}));
  CHECK(has_values<double>(colours("0,0,200", "1,2,.5"), "blue", {200, 0.5}));
  CHECK(has_values<double>(colours("0,0,200", "1,2,-1"), "blue", {200, -1}));
  CHECK(has_values<double>(colours("0,0,1", "1,0,0"), "blue", {1, 0}));
}

TEST_CASE("cells") {
  CHECK(refusal("a.csv", "x,y,z\n1,,3\n") == "2: expected a number, found an empty cell");
  CHECK(refusal("a.csv", "1,2,3\n,4,5\n") == "2: expected a number, found an empty cell");
  CHECK(names("a.csv", "1,2,3\n,,\n4,5,6\n , \n") == "");
  const std::string decimal =
      ": commas and other separators between coordinates: write decimal points, not commas";
  CHECK(refusal("a.csv", "1,5;2,5;3,5\n") == "1" + decimal);
  CHECK(refusal("a.csv", "1;2;3\n1;2,5;3\n") == "2" + decimal);
  CHECK(refusal("a.xyz", "1,5 2,5 3,5\n") == "1" + decimal);
  CHECK(names("a.csv", "1, 2,3\n4 ,5\t, 6\n") == "");
}

}  // namespace
}  // namespace tetsculpt
