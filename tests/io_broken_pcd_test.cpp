// Broken PCD files are refused with the line, or the byte of binary data, of the fault.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <string>

#include "tests/support/io_files.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::refusal;

const std::string kXyz = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n";

std::string refused(const std::string& text) { return refusal("a.pcd", text); }

TEST_CASE("header") {
  CHECK(refused("") == "1: the file ends within the PCD header");
  CHECK(refused(kXyz) == "3: the file ends within the PCD header");
  CHECK(refused(kXyz + "COLOURS 3\n") == "4: not a line of a PCD header");
  CHECK(refused(kXyz + "DATA ascii\n") == "4: the header has no POINTS");
  CHECK(refused(kXyz + "POINTS 1\nDATA text\n") ==
        "5: unknown DATA; ascii, binary and binary_compressed are read");
  CHECK(refused(kXyz + "POINTS -1\n") == "4: expected a count, found '-1'");
  CHECK(refused(kXyz + "WIDTH 2\nHEIGHT 3\nPOINTS 5\nDATA ascii\n") ==
        "7: POINTS is 5, WIDTH times HEIGHT is 6");
  CHECK(refused(kXyz + "WIDTH 4294967296\nHEIGHT 4294967296\nDATA ascii\n") ==
        "6: WIDTH times HEIGHT is out of range");
}

TEST_CASE("fields") {
  const std::string end = "POINTS 0\nDATA ascii\n";
  CHECK(refused("FIELDS x y z\nSIZE 4 4\nTYPE F F F\n" + end) ==
        "5: FIELDS names 3 fields, SIZE has 2 values");
  CHECK(refused("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F F\n" + end) ==
        "5: FIELDS names 3 fields, TYPE has 4 values");
  CHECK(refused(kXyz + "COUNT 1 1\n" + end) == "6: FIELDS names 3 fields, COUNT has 2 values");
  CHECK(refused("FIELDS x y z\nSIZE 4 4 2\nTYPE F F F\n" + end) ==
        "5: no type of numbers has TYPE F and SIZE 2");
  CHECK(refused("FIELDS x y z\nSIZE 4 4 4\nTYPE F F FF\n" + end) ==
        "5: unknown TYPE of the field z");
  CHECK(refused("FIELDS x y w\nSIZE 4 4 4\nTYPE F F F\n" + end) ==
        "5: FIELDS does not name x, y and z once each");
  CHECK(refused(kXyz + "COUNT 1 1 2\n" + end) == "6: the field z has several numbers");
  CHECK(refused(kXyz + "COUNT 1 1 0\n" + end) ==
        "6: a COUNT is zero, or a point has more than 10000 numbers");
  const std::string hist = "FIELDS x y z h\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 ";
  CHECK(refused(hist + "9997\n" + end) == "read");
  CHECK(refused(hist + "9998\n" + end) ==
        "6: a COUNT is zero, or a point has more than 10000 numbers");
  CHECK(refused(kXyz + "COUNT 1 1 18446744073709551615\n" + end) ==
        "6: a COUNT is zero, or a point has more than 10000 numbers");
}

TEST_CASE("ascii data") {
  CHECK(refused(kXyz + "POINTS 2\nDATA ascii\n1 2 3\n") == "6: the file ends after 1 of 2 points");
  CHECK(refused(kXyz + "POINTS 1\nDATA ascii\n1 2\n") ==
        "6: expected a number, found the end of the line");
  CHECK(refused(kXyz + "POINTS 1\nDATA ascii\n1 2 3 4\n") ==
        "6: the line has more values than the header says");
  CHECK(refused(kXyz + "POINTS 1\nDATA ascii\n1 2 1e39\n") == "6: number out of range: '1e39'");
  CHECK(refused(kXyz + "POINTS 1000000000000000000\nDATA ascii\n1 2 3\n") ==
        "6: the file ends after 1 of 1000000000000000000 points");
}

// The place is told from the begin of the data.
std::string refused_data(const std::string& kind, const std::string& points,
                         const std::string& data) {
  const std::string header = kXyz + "POINTS " + points + "\nDATA " + kind + "\n";
  const std::string text = refused(header + data);
  const std::string place = "byte " + std::to_string(header.size());
  return text.starts_with(place) ? "data" + text.substr(place.size()) : text;
}

TEST_CASE("binary data") {
  CHECK(refused_data("binary", "2", std::string(23, '\0')) ==
        "data: points: 2 of 12 bytes announced, 23 bytes left");
  CHECK(refused_data("binary", "18446744073709551615", std::string(24, '\0'))
            .starts_with("data: points: 18446744073709551615 of 12"));
  CHECK(refused_data("binary", "2", std::string(24, '\0')) == "read");
}

TEST_CASE("compressed data") {
  const auto sizes = [](std::uint32_t compressed, std::uint32_t whole) {
    return testing::bytes(compressed, std::endian::little) +
           testing::bytes(whole, std::endian::little);
  };
  const auto refused_bytes = [](const std::string& points, const std::string& data) {
    return refused_data("binary_compressed", points, data);
  };
  const std::string body = "\x0B" + std::string(12, '\0');
  CHECK(refused_bytes("1", sizes(13, 12) + body) == "read");
  CHECK(refused_bytes("1", "1234567") ==
        "data: the file ends before the sizes of its compressed data");
  CHECK(refused_bytes("1", sizes(13, 13) + body) ==
        "data: points: 1 of 12 bytes announced, compressed data of 13 bytes");
  CHECK(refused_bytes("2", sizes(13, 12) + body) ==
        "data: points: 2 of 12 bytes announced, compressed data of 12 bytes");
  CHECK(refused_bytes("1", sizes(14, 12) + body) ==
        "data: compressed data: 14 bytes announced, 13 bytes left");
  CHECK(refused_bytes("1", sizes(12, 12) + body) == "data: the compressed data is broken");
  CHECK(refused_bytes("357913941", sizes(13, 4294967292U) + body) ==
        "data: the compressed data is broken");
}

}  // namespace
}  // namespace tetsculpt
