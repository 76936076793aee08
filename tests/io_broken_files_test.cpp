// Broken texts, OBJ and OFF files are refused with the line of the fault.
#include <doctest/doctest.h>

#include <string>

#include "tests/support/io_files.h"

namespace tetsculpt {
namespace {

using testing::refusal;

TEST_CASE("text: lines without three numbers") {
  CHECK(refusal("a.xyz", "1 2 3\n1 2\n") == "2: expected a number, found the end of the line");
  CHECK(refusal("a.xyz", "1 2 3\n7\n") == "2: expected a number, found the end of the line");
  CHECK(refusal("a.xyz", "1 2\n1 2 3\n") == "1: expected a number, found the end of the line");
  CHECK(refusal("a.csv", "1,2,3\n\n4,five,6\n") == "3: expected a number, found 'five'");
  CHECK(refusal("a.txt", "0 0 0\r\n0 0 0x1\r\n") == "2: expected a number, found '0x1'");
  CHECK(refusal("a.txt", "0 0 0\r0 0 0\r0 0 1.5.2\r") == "3: expected a number, found '1.5.2'");
  CHECK(refusal("a.pts", "#\n1 2 3\nx y z\n") == "3: expected a number, found 'x'");
  CHECK(refusal("a.pts", "1 2 +-3\n") == "1: expected a number, found '+-3'");
  CHECK(refusal("a.asc", "1 2 3\n1e 2 3") == "2: expected a number, found '1e'");
}

TEST_CASE("text: only one line of titles") {
  CHECK(refusal("a.csv", "x,y,z\nm,m,m\n1,2,3\n") == "2: expected a number, found 'm'");
  CHECK(refusal("a.xyz", "2\nwater\nO 0 0 0\nH 1 0 0\n") == "3: expected a number, found 'O'");
}

TEST_CASE("text: a count that does not hold") {
  CHECK(refusal("a.pts", "# scan\n3\n1 2 3\n4 5 6\n") ==
        "2: announced points: 3, points in the file: 2");
  CHECK(refusal("a.pts", "1\n1 2 3\n4 5 6\n") == "1: announced points: 1, points in the file: 2");
  CHECK(refusal("a.pts", "-1\n1 2 3\n") == "1: expected a number, found the end of the line");
  CHECK(refusal("a.pts", "99999999999999999999\n1 2 3\n") ==
        "1: expected a count, found '99999999999999999999'");
}

TEST_CASE("text: numbers out of range") {
  CHECK(refusal("a.xyz", "0 0 0\n0 1e400 0\n") == "2: number out of range: '1e400'");
  CHECK(refusal("a.xyz", "-1e309 0 0\n") == "1: number out of range: '-1e309'");
  CHECK(refusal("a.xyz", "1e-400 -1e-400 0\n") == "read");
}

TEST_CASE("messages stay short and printable") {
  CHECK(refusal("a.xyz", "0 0 0\n0 \x01\xFF 0\n") ==
        "2: expected a number, found '?"
        "?'");
  CHECK(refusal("a.xyz", "0 0 0\n" + std::string(1000, 'q')) ==
        "2: expected a number, found '" + std::string(40, 'q') + "...'");
  CHECK(refusal("a.xyz", std::string("0 0 0\n0\0 0 0\n", 13)) ==
        "2: expected a number, found '0?'");
}

TEST_CASE("obj") {
  CHECK(refusal("a.obj", "v 0 0 0\nv 1 2\n") == "2: expected a number, found the end of the line");
  CHECK(refusal("a.obj", "v 0 0 0\n\nv 1 2 c\n") == "3: expected a number, found 'c'");
  CHECK(refusal("a.obj", "v 0 0 1e999\n") == "1: number out of range: '1e999'");
}

TEST_CASE("off: header") {
  const std::string no_off = "not an OFF file: it does not begin with OFF";
  CHECK(refusal("a.off", "") == "1: " + no_off);
  CHECK(refusal("a.off", "\n# x\n3 1 0\n") == "3: " + no_off);
  CHECK(refusal("a.off", "4OFF\n0 0 0\n") == "1: " + no_off);
  CHECK(refusal("a.off", "solid\n") == "1: " + no_off);
  CHECK(refusal("a.off", "OFF BINARY\n") == "1: binary OFF files are not read");
  CHECK(refusal("a.off", "OFF\n# no more\n") == "2: the file ends before its counts");
  CHECK(refusal("a.off", "OFF\n-3 1 0\n") == "2: expected a count, found '-3'");
  CHECK(refusal("a.off", "OFF\n3 -1 0\n") == "2: expected a count, found '-1'");
  CHECK(refusal("a.off", "OFF\n3.5 1 0\n") == "2: expected a count, found '3.5'");
}

TEST_CASE("off: body") {
  CHECK(refusal("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n") == "4: the file ends after 2 of 3 vertices");
  CHECK(refusal("a.off", "OFF\n1000000000000000000 0 0\n0 0 0\n") ==
        "3: the file ends after 1 of 1000000000000000000 vertices");
  CHECK(refusal("a.off", "OFF\n2 0 0\n0 0 0\n1 0\n") ==
        "4: expected a number, found the end of the line");
  CHECK(refusal("a.off", "OFF 1 0 0\n0 0 z # last\n") == "2: expected a number, found 'z'");
}

}  // namespace
}  // namespace tetsculpt
