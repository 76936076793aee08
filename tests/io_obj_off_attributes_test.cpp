// OBJ and OFF: colours and normals of vertices.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "tests/support/io_files.h"
#include "tests/support/io_point_attributes.h"

namespace tetsculpt {
namespace {

using testing::attribute_names;
using testing::has_values;
using testing::read_content;

std::string names(std::string_view name, std::string_view text) {
  CAPTURE(text);
  const PointFile file = read_content(name, text);
  CHECK(file.points.size() == 2);
  CHECK(file.points.back() == Point3{1, 2, 3});
  return attribute_names(file);
}

TEST_CASE("obj") {
  CHECK(names("a.obj", "v 0 0 0\nv 1 2 3\n") == "");
  CHECK(names("a.obj", "v 0 0 0 1\nv 1 2 3 1\n") == "");
  CHECK(names("a.obj", "v 0 0 0 1 0 .5\nvn 0 0 1\nv 1 2 3 1 0 0\n") == "red green blue");
  CHECK(names("a.obj", "v 0 0 0 1 1 0 .5\nv 1 2 3 1 0 0 0\n") == "red green blue");
  CHECK(names("a.obj", "v 0 0 0 1 0 .5\nv 1 2 3\n") == "");
  CHECK(names("a.obj", "v 0 0 0 1 0\nv 1 2 3 0 1\n") == "scalar_4 scalar_5");
}

TEST_CASE("obj: colours are shares, or integers") {
  CHECK(has_values<double>(read_content("a.obj", "v 0 0 0 1 0 .5\n"), "blue", {0.5}));
  CHECK(has_values<double>(read_content("a.obj", "v 0 0 0 1 0 1\n"), "red", {1}));
  CHECK(has_values<std::uint8_t>(read_content("a.obj", "v 0 0 0 128 0 1\n"), "red", {128}));
}

TEST_CASE("off: what the keyword announces") {
  CHECK(names("a.off", "OFF 2 0 0\n0 0 0\n1 2 3\n") == "");
  CHECK(names("a.off", "COFF 2 0 0\n0 0 0 9 9 9 9\n1 2 3 9 9 9 9\n") == "red green blue alpha");
  CHECK(names("a.off", "COFF 2 0 0\n0 0 0 9 9 9\n1 2 3 9 9 9\n") == "red green blue");
  CHECK(names("a.off", "NOFF 2 0 0\n0 0 0 0 0 1\n1 2 3 0 0 1\n") == "nx ny nz");
  CHECK(names("a.off", "CNOFF 2 0 0\n0 0 0 0 0 1 9 9 9\n1 2 3 0 0 1 9 9 9\n") ==
        "nx ny nz red green blue");
  CHECK(names("a.off", "STOFF 2 0 0\n0 0 0 .5 .5\n1 2 3 0 1\n") == "s t");
  CHECK(names("a.off", "STCOFF 2 0 0\n0 0 0 1 0 0 1 .5 .5\n1 2 3 1 0 0 1 0 1\n") ==
        "red green blue alpha s t");
}

TEST_CASE("off: other numbers") {
  CHECK(names("a.off", "COFF 2 0 0\n0 0 0 9\n1 2 3 9\n") == "scalar_4");
  CHECK(names("a.off", "OFF 2 0 0\n0 0 0 9 9 9 9\n1 2 3 9 9 9 9\n") ==
        "scalar_4 scalar_5 scalar_6 scalar_7");
  CHECK(names("a.off", "COFF 2 0 0\n0 0 0 9 9 9\n1 2 3 9\n") == "red");
}

TEST_CASE("off: values") {
  const PointFile file =
      read_content("a.off", "CNOFF 2 0 0\n0 0 0 0 0 -1 0 255 7\n1 2 3 1 .5 0 1 2 3\n");
  CHECK(has_values<double>(file, "nz", {-1, 0}));
  CHECK(has_values<std::uint8_t>(file, "green", {255, 2}));
}

}  // namespace
}  // namespace tetsculpt
