// Binary PLY: every type of coordinate, order of properties and byte order.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/io_files.h"
#include "tests/support/io_hard_points.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::bytes;
using testing::format_name;
using testing::kXyzFloat;
using testing::ply_header;
using testing::read_content;
using testing::same_bits;

constexpr std::array kOrders = {std::endian::little, std::endian::big};

template <typename Number>
void check_type(const std::string& type, std::endian order) {
  CAPTURE(type);
  using Limits = std::numeric_limits<Number>;
  const std::array<Number, 6> values = {Limits::lowest(), Limits::max(), Number(100),
                                        Limits::min(),    Number(0),     Number(1)};
  std::string content =
      ply_header(format_name(order), "element vertex 2\nproperty " + type + " x\nproperty " + type +
                                         " y\nproperty " + type + " z\n");
  for (const Number value : values) content += bytes(value, order);
  const auto at = [&](std::size_t i) { return static_cast<double>(values[i]); };
  const std::vector<Point3> expected = {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}};
  CHECK(same_bits(read_content("a.ply", content).points, expected));
}

TEST_CASE("every type of coordinate under each of its names") {
  for (const std::endian order : kOrders) {
    for (const char* name : {"char", "int8"}) check_type<std::int8_t>(name, order);
    for (const char* name : {"uchar", "uint8"}) check_type<std::uint8_t>(name, order);
    for (const char* name : {"short", "int16"}) check_type<std::int16_t>(name, order);
    for (const char* name : {"ushort", "uint16"}) check_type<std::uint16_t>(name, order);
    for (const char* name : {"int", "int32"}) check_type<std::int32_t>(name, order);
    for (const char* name : {"uint", "uint32"}) check_type<std::uint32_t>(name, order);
    for (const char* name : {"float", "float32"}) check_type<float>(name, order);
    for (const char* name : {"double", "float64"}) check_type<double>(name, order);
  }
}

TEST_CASE("x, y, z of three types in any order among other properties") {
  for (const std::endian order : kOrders) {
    std::array<int, 5> permutation = {0, 1, 2, 3, 4};
    const std::array<std::string, 5> lines = {"property short x\n", "property float y\n",
                                              "property double z\n", "property uchar red\n",
                                              "property int32 flags\n"};
    do {
      std::string header = "element vertex 2\n";
      for (const int i : permutation) header += lines[static_cast<std::size_t>(i)];
      std::string body;
      for (const std::int16_t vertex : {std::int16_t{-300}, std::int16_t{7}}) {
        const std::array<std::string, 5> values = {
            bytes(vertex, order), bytes(0.5F, order), bytes(-0.1, order),
            bytes(std::uint8_t{200}, order), bytes(std::int32_t{-1}, order)};
        for (const int i : permutation) body += values[static_cast<std::size_t>(i)];
      }
      const std::string content = ply_header(format_name(order), header) + body;
      const std::vector<Point3> expected = {{-300, 0.5, -0.1}, {7, 0.5, -0.1}};
      REQUIRE(same_bits(read_content("a.ply", content).points, expected));
    } while (std::ranges::next_permutation(permutation).found);
  }
}

TEST_CASE("lists in and elements before the vertices") {
  for (const std::endian order : kOrders) {
    const std::string content =
        ply_header(format_name(order),
                   "element camera 2\nproperty double x\nproperty char y\nelement none 9\n"
                   "element strip 2\nproperty uchar k\nproperty list int short ids\n"
                   "element vertex 2\nproperty list uchar double w\nproperty float z\n"
                   "property float y\nproperty list short char s\nproperty float x\n"
                   "element face 1\nproperty list uchar int vertex_indices\n") +
        std::string(2 * 9, '\xAA') +                                    // cameras
        "k" + bytes(std::int32_t{3}, order) + std::string(6, '\xBB') +  // strips
        "k" + bytes(std::int32_t{0}, order) +                           //
        bytes(std::uint8_t{2}, order) + std::string(16, '\xCC') +       // first vertex
        bytes(3.0F, order) + bytes(2.0F, order) +                       //
        bytes(std::int16_t{0}, order) + bytes(1.0F, order) +            //
        bytes(std::uint8_t{0}, order) + bytes(6.5F, order) +            // second vertex
        bytes(5.0F, order) + bytes(std::int16_t{1}, order) + "\x7F" + bytes(-4.0F, order);
    const PointFile file = read_content("a.ply", content);
    CHECK(file.precision == Precision::kSingle);
    CHECK(same_bits(file.points, std::vector<Point3>{{1, 2, 3}, {-4, 5, 6.5}}));
  }
}

TEST_CASE("a first byte that looks like a line end belongs to the body") {
  const float value = std::bit_cast<float>(std::uint32_t{0x0A0A0A0A});
  const std::vector<Point3> expected(1, {double{value}, double{value}, double{value}});
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string content;
    const std::string header =
        ply_header(format_name(std::endian::little), "element vertex 1\n" + std::string(kXyzFloat));
    for (const char c : header) content += c == '\n' ? end : std::string(1, c);
    CHECK(same_bits(read_content("a.ply", content + std::string(12, '\n')).points, expected));
  }
}

}  // namespace
}  // namespace tetsculpt
