// PLY: every scalar of a vertex besides x, y and z becomes an attribute of its type.
#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_ply_bytes.h"
#include "tests/support/io_point_attributes.h"

namespace tetsculpt {
namespace {

using testing::attribute_names;
using testing::bytes;
using testing::format_name;
using testing::has_values;
using testing::kXyzFloat;
using testing::ply_header;
using testing::read_content;
using testing::refusal;

constexpr std::array kOrders = {std::endian::little, std::endian::big};

template <typename Number>
void check_type(const std::string& type) {
  CAPTURE(type);
  using Limits = std::numeric_limits<Number>;
  const std::vector<Number> values = {Limits::lowest(), Limits::max(), Number(100), Number(0)};
  for (const bool with_list : {false, true}) {
    const std::string elements = "element vertex 4\nproperty " + type + " value\n" +
                                 (with_list ? "property list uchar int ids\n" : "") +
                                 std::string(kXyzFloat);
    for (const std::endian order : kOrders) {
      std::string content = ply_header(format_name(order), elements);
      for (const Number value : values) {
        content += bytes(value, order) + (with_list ? std::string("\1abcd", 5) : "") +
                   std::string(12, '\0');
      }
      const PointFile file = read_content("a.ply", content);
      CHECK(file.points.size() == 4);
      CHECK(file.attributes.size() == 1);
      CHECK(has_values(file, "value", values));
    }
  }
}

TEST_CASE("binary: every type, both orders, with and without lists") {
  check_type<std::int8_t>("char");
  check_type<std::uint8_t>("uchar");
  check_type<std::int16_t>("short");
  check_type<std::uint16_t>("ushort");
  check_type<std::int32_t>("int");
  check_type<std::uint32_t>("uint");
  check_type<float>("float");
  check_type<double>("double");
}

TEST_CASE("ascii: every type, in any place") {
  const PointFile file = read_content(
      "a.ply", ply_header("ascii",
                          "element vertex 2\nproperty char a\nproperty float x\nproperty uchar b\n"
                          "property short c\nproperty float y\nproperty list uchar int l\n"
                          "property ushort d\nproperty int e\nproperty float z\nproperty uint f\n"
                          "property float g\nproperty double h\n") +
                   "-128 1 255 -32768 2 2 7 7 65535 -2147483648 3 4294967295 0.1 0.1\n"
                   "127 4 0.0 1 5 0 2 3 6 4 nan -1e300\n");
  CHECK(file.points == std::vector<Point3>{{1, 2, 3}, {4, 5, 6}});
  CHECK(attribute_names(file) == "a b c d e f g h");
  CHECK(has_values<std::int8_t>(file, "a", {-128, 127}));
  CHECK(has_values<std::uint8_t>(file, "b", {255, 0}));
  CHECK(has_values<std::int16_t>(file, "c", {-32768, 1}));
  CHECK(has_values<std::uint16_t>(file, "d", {65535, 2}));
  CHECK(has_values<std::int32_t>(file, "e", {-2147483647 - 1, 3}));
  CHECK(has_values<std::uint32_t>(file, "f", {4294967295U, 4}));
  CHECK(std::get<std::vector<float>>(file.attributes[6].values)[0] == 0.1F);
  CHECK(has_values<double>(file, "h", {0.1, -1e300}));
}

TEST_CASE("ascii: a value that its type cannot hold") {
  const auto refused = [](const std::string& type, const std::string& value) {
    return refusal("a.ply", ply_header("ascii", "element vertex 1\n" + std::string(kXyzFloat) +
                                                    "property " + type + " v\n") +
                                "0 0 0 " + value + "\n");
  };
  CHECK(refused("uchar", "256") == "9: expected a whole number from 0 to 255");
  CHECK(refused("uchar", "-1") == "9: expected a whole number from 0 to 255");
  CHECK(refused("uchar", "0.5") == "9: expected a whole number from 0 to 255");
  CHECK(refused("char", "nan") == "9: expected a whole number from -128 to 127");
  CHECK(refused("int", "2147483648") ==
        "9: expected a whole number from -2147483648 to 2147483647");
  CHECK(refused("float", "1e39") == "9: number out of range: '1e39'");
  CHECK(refused("double", "red") == "9: expected a number, found 'red'");
  CHECK(refused("double", "") == "9: expected a number, found the end of the line");
  CHECK(refused("uint", "4294967295") == "read");
}

TEST_CASE("names stay, and are made distinct") {
  const PointFile file = read_content(
      "a.ply", ply_header("ascii", "element vertex 0\n" + std::string(kXyzFloat) +
                                       "property uchar Red\nproperty uchar r\nproperty int r\n"
                                       "property int r_2\nproperty int r\nproperty int r\n"));
  CHECK(attribute_names(file) == "Red r r_2 r_2_2 r_3 r_4");
}

TEST_CASE("other elements have no attributes") {
  const PointFile file = read_content(
      "a.ply", ply_header("ascii", "element a 1\nproperty int i\nelement vertex 1\n" +
                                       std::string(kXyzFloat) + "element b 1\nproperty int i\n") +
                   "1\n0 0 0\n1\n");
  CHECK(file.attributes.empty());
}

}  // namespace
}  // namespace tetsculpt
