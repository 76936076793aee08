// PCD: all three kinds of data give the same points and attributes.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_ply_bytes.h"
#include "tests/support/io_point_attributes.h"

namespace tetsculpt {
namespace {

using testing::attribute_names;
using testing::has_values;
using testing::read_content;

template <typename Number>
std::string little(Number value) {
  return testing::bytes(value, std::endian::little);
}

std::string header(const std::string& fields, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields +
         "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA " + data + "\n";
}

// The sizes and LibLZF's format without any repeat.
std::string compressed(std::string_view bytes) {
  std::string packed;
  for (std::string_view rest = bytes; !rest.empty();) {
    const std::string_view part = rest.substr(0, 32);
    packed += static_cast<char>(part.size() - 1);
    packed += part;
    rest.remove_prefix(part.size());
  }
  return little(static_cast<std::uint32_t>(packed.size())) +
         little(static_cast<std::uint32_t>(bytes.size())) + packed;
}

const std::string kFields =
    "FIELDS z y x rgb _ normal_x label hist stamp\nSIZE 4 4 4 4 1 8 2 1 8\n"
    "TYPE F F F F U F I U U\nCOUNT 1 1 1 1 3 1 1 2 1\n";

void check(const PointFile& file) {
  CHECK(file.points == std::vector<Point3>{{1, 2, 3}, {4, 5, double{0.1F}}});
  CHECK(file.precision == Precision::kSingle);
  CHECK(attribute_names(file) == "red green blue nx label hist_0 hist_1 stamp");
  CHECK(has_values<std::uint8_t>(file, "red", {1, 255}));
  CHECK(has_values<std::uint8_t>(file, "green", {2, 0}));
  CHECK(has_values<std::uint8_t>(file, "blue", {3, 128}));
  CHECK(has_values<double>(file, "nx", {0.1, -1}));
  CHECK(has_values<std::int16_t>(file, "label", {-7, 8}));
  CHECK(has_values<std::uint8_t>(file, "hist_0", {10, 30}));
  CHECK(has_values<std::uint8_t>(file, "hist_1", {20, 40}));
  CHECK(has_values<double>(file, "stamp", {0x1p60, 5}));
}

const float kFirstColour = std::bit_cast<float>(std::uint32_t{0x010203});
const float kSecondColour = std::bit_cast<float>(std::uint32_t{0xFF0080});

TEST_CASE("ascii") {
  check(read_content("a.pcd", header(kFields, "ascii") +
                                  "3 2 1 9.25571649e-41 0 0 0 0.1 -7 10 20 1152921504606846976\n"
                                  "0.1 5 4 2.34182309e-38 0 0 0 -1 8 30 40 5\n"));
}

TEST_CASE("binary") {
  const std::string pad(3, '\xEE');
  check(read_content(
      "a.pcd", header(kFields, "binary") + little(3.0F) + little(2.0F) + little(1.0F) +
                   little(kFirstColour) + pad + little(0.1) + little(std::int16_t{-7}) +
                   "\x0A\x14" + little(std::uint64_t{1} << 60) + little(0.1F) + little(5.0F) +
                   little(4.0F) + little(kSecondColour) + pad + little(-1.0) +
                   little(std::int16_t{8}) + "\x1E\x28" + little(std::uint64_t{5}) + "trailing"));
}

TEST_CASE("binary_compressed") {
  const std::string pads(6, '\xEE');
  const std::string fields =
      little(3.0F) + little(0.1F) + little(2.0F) + little(5.0F) + little(1.0F) + little(4.0F) +
      little(kFirstColour) + little(kSecondColour) + pads + little(0.1) + little(-1.0) +
      little(std::int16_t{-7}) + little(std::int16_t{8}) + "\x0A\x14\x1E\x28" +
      little(std::uint64_t{1} << 60) + little(std::uint64_t{5});
  check(read_content("a.pcd", header(kFields, "binary_compressed") + compressed(fields)));
}

TEST_CASE("colours of every type; alpha") {
  const auto file = [](const std::string& name, const std::string& type, const char* value) {
    return read_content(
        "a.pcd",
        header("FIELDS x y z " + name + "\nSIZE 4 4 4 4\nTYPE F F F " + type + "\n", "ascii") +
            "0 0 0 " + value + "\n0 0 0 0\n");
  };
  CHECK(has_values<std::uint8_t>(file("rgb", "U", "4278321667"), "green", {2, 0}));
  CHECK(has_values<std::uint8_t>(file("rgb", "I", "-1"), "green", {255, 0}));
  CHECK(has_values<std::uint8_t>(file("rgb", "F", "nan"), "red", {0, 0}));
  CHECK(attribute_names(file("rgba", "U", "4278321667")) == "red green blue alpha");
  CHECK(has_values<std::uint8_t>(file("rgba", "U", "4278321667"), "alpha", {255, 0}));
}

TEST_CASE("a binary colour with alpha 255 is no number as a float") {
  const std::string file = header("FIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F F\n", "binary") +
                           std::string(12, '\0') + little(std::uint32_t{0xFF010203}) +
                           std::string(16, '\0');
  CHECK(has_values<std::uint8_t>(read_content("a.pcd", file), "red", {1, 0}));
  CHECK(has_values<std::uint8_t>(read_content("a.pcd", file), "alpha", {255, 0}));
}

TEST_CASE("coordinates of other types, no COUNT, NaN, CRLF") {
  const PointFile file = read_content(
      "a.pcd",
      "VERSION .7\r\nFIELDS x y z\r\nSIZE 2 8 4\r\nTYPE I F F\r\nWIDTH 1\r\nHEIGHT 2\r\n"
      "POINTS 2\r\nDATA ascii\r\n-3 0.1 nan\r\n1 2 3\r\n");
  CHECK(file.precision == Precision::kDouble);
  REQUIRE(file.points.size() == 2);
  CHECK(file.points[0].x == -3);
  CHECK(file.points[0].y == 0.1);
  CHECK(std::isnan(file.points[0].z));
}

}  // namespace
}  // namespace tetsculpt
