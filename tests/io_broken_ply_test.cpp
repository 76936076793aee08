// Broken PLY files are refused with the line, or the byte of a binary body, of the fault.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/support/io_files.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::bytes;
using testing::kXyzFloat;
using testing::ply_header;
using testing::refusal;

const std::string kXyz(kXyzFloat);
constexpr std::endian kLittle = std::endian::little;

std::string refused_header(const std::string& lines) {
  return refusal("a.ply", "ply\nformat ascii 1.0\n" + lines);
}

TEST_CASE("not a PLY file") {
  CHECK(refusal("a.ply", "") == "1: not a PLY file");
  CHECK(refusal("a.ply", "solid\n") == "1: not a PLY file");
  CHECK(refusal("a.ply", "plyx\nformat ascii 1.0\n") == "1: not a PLY file");
  CHECK(refusal("a.ply", std::string(100, '\0')) == "1: not a PLY file");
}

TEST_CASE("header: format") {
  const std::string vertex = "element vertex 0\n" + kXyz + "end_header\n";
  CHECK(refusal("a.ply", "ply\nformat ascii 2.0\n" + vertex) == "2: the format version is not 1.0");
  CHECK(refusal("a.ply", "ply\nformat binary 1.0\n" + vertex) == "2: unknown format 'binary'");
  CHECK(refusal("a.ply", "ply\n" + vertex) == "6: the header has no format line");
  CHECK(refused_header("format ascii 1.0\n") == "3: a second format line");
}

TEST_CASE("header: lines") {
  CHECK(refused_header("element vertex 1\n" + kXyz) == "6: the file ends within the header");
  CHECK(refused_header("element vertex 1\n" + kXyz + "0 0 0\n") == "7: not a line of a PLY header");
  CHECK(refused_header("property float x\n") == "3: a property before the first element");
  CHECK(refused_header("element vertex\n") == "3: expected a count, found the end of the line");
  CHECK(refused_header("element vertex -1\n") == "3: expected a count, found '-1'");
  CHECK(refused_header("element vertex 99999999999999999999\n") ==
        "3: expected a count, found '99999999999999999999'");
  CHECK(refused_header("element\n") == "3: the element has no name");
  CHECK(refused_header("element vertex 1\nproperty real x\n") == "4: unknown type 'real'");
  CHECK(refused_header("element vertex 1\nproperty float\n") == "4: the property has no name");
  CHECK(refused_header("element face 1\nproperty list float int i\n") ==
        "4: a list length must be an integer");
}

TEST_CASE("header: the vertex element") {
  CHECK(refused_header("end_header\n") == "3: the header has no element vertex");
  CHECK(refused_header("element vertex 1\nproperty float x\nproperty float y\nend_header\n") ==
        "6: the element vertex has no property z");
  CHECK(refused_header("element vertex 1\n" + kXyz + "property int x\nend_header\n") ==
        "7: a coordinate for the second time");
  CHECK(refused_header("element vertex 1\nproperty list int float x\nproperty float y\n"
                       "property float z\nend_header\n") == "7: the property x is a list");
  CHECK(refused_header("element vertex 1\n" + kXyz + "element vertex 1\n") ==
        "7: a second element vertex");
}

TEST_CASE("ascii body") {
  const auto refused = [](const std::string& count, const std::string& body) {
    return refusal("a.ply", ply_header("ascii", "element vertex " + count + "\n" + kXyz) + body);
  };
  CHECK(refused("2", "0 0 0\n") == "8: the file ends after 1 of 2 elements vertex");
  CHECK(refused("1", "") == "7: the file ends after 0 of 1 elements vertex");
  CHECK(refused("1000000000000000000", "0 0 0\n") ==
        "8: the file ends after 1 of 1000000000000000000 elements vertex");
  CHECK(refused("1", "0 0\n") == "8: expected a number, found the end of the line");
  CHECK(refused("2", "0 0 0\n\n0 x 0\n") == "10: expected a number, found 'x'");
  CHECK(refused("1", "0 0 0 0\n") == "8: the line has more values than the header says");
  CHECK(refused("1", "0 0 1e39\n") == "8: number out of range: '1e39'");
  CHECK(refused("1", "0 nan -inf\n") == "read");
}

TEST_CASE("ascii body: lists and elements before") {
  const std::string list =
      ply_header("ascii", "element vertex 1\n" + kXyz + "property list uchar int ids\n");
  CHECK(refusal("a.ply", list + "0 0 0 1000000000000000000 1\n") ==
        "9: the line has fewer values than the header says");
  CHECK(refusal("a.ply", list + "0 0 0 -1\n") == "9: expected a count, found '-1'");
  CHECK(refusal("a.ply", ply_header("ascii",
                                    "element a 1000000000000000000\nproperty int i\n"
                                    "element vertex 1\n" +
                                        kXyz) +
                             "1\n2\n") ==
        "11: the file ends after 2 of 1000000000000000000 elements a");
}

// What is said of a binary body, without the header's length in the byte.
std::string refused_body(const std::string& elements, const std::string& body) {
  const std::string header = ply_header("binary_little_endian", elements);
  const std::string text = refusal("a.ply", header + body);
  if (!text.starts_with("byte ")) return text;
  const std::size_t colon = text.find(':');
  const std::size_t byte = std::stoul(text.substr(5, colon - 5));
  return "body + " + std::to_string(byte - header.size()) + text.substr(colon);
}

TEST_CASE("binary body: fewer vertices than announced") {
  CHECK(refused_body("element vertex 2\n" + kXyz, std::string(23, '\0')) ==
        "body + 0: vertices: 2 of at least 12 bytes announced, 23 bytes left");
  CHECK(refused_body("element vertex 1000000000000000000\n" + kXyz, std::string(24, '\0')) ==
        "body + 0: vertices: 1000000000000000000 of at least 12 bytes announced, 24 bytes left");
  // 2^64 / 12 rounded up: the product would wrap to a small number.
  CHECK(refused_body("element vertex 1537228672809129302\n" + kXyz, std::string(24, '\0'))
            .starts_with("body + 0: vertices: 1537228672809129302 of"));
  CHECK(refused_body("element vertex 2\n" + kXyz, std::string(24, '\0')) == "read");
}

TEST_CASE("binary body: elements before the vertices") {
  const std::string vertex = "element vertex 1\n" + kXyz;
  CHECK(refused_body("element a 1000000000000000000\nproperty int i\n" + vertex,
                     std::string(16, '\0')) ==
        "body + 0: elements a: 1000000000000000000 of at least 4 bytes announced, 16 bytes left");
  CHECK(refused_body("element a 1000000000000000000\n" + vertex, std::string(12, '\0')) == "read");
  CHECK(refused_body("element a 2\nproperty int i\n" + vertex, std::string(19, '\0')) ==
        "body + 8: vertices: 1 of at least 12 bytes announced, 11 bytes left");
}

TEST_CASE("binary body: lists") {
  const std::string elements = "element a 2\nproperty list int double i\nelement vertex 1\n" + kXyz;
  const std::string empty = bytes(std::int32_t{0}, kLittle);
  CHECK(refused_body(elements, empty + bytes(std::int32_t{-1}, kLittle) + std::string(50, '\0')) ==
        "body + 4: negative length of a list");
  CHECK(refused_body(elements, empty + bytes(std::int32_t{2}, kLittle) + std::string(15, '\0')) ==
        "body + 8: list items: 2 of at least 8 bytes announced, 15 bytes left");
  const std::string in_vertex = "element vertex 2\nproperty list uchar int i\n" + kXyz;
  CHECK(refused_body(in_vertex, std::string("\x02").append(8 + 12 + 5, '\0')) ==
        "body + 26: value: 1 of at least 4 bytes announced, 0 bytes left");
}

}  // namespace
}  // namespace tetsculpt
