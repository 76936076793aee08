// Whatever a header announces, and however long a line is: memory stays in proportion to the file.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>

#include "io/io_error.h"
#include "io/read_points.h"
#include "tests/support/io_las_bytes.h"
#include "tests/support/random_cases.h"

namespace {

std::atomic<std::size_t> live_bytes = 0;
std::atomic<std::size_t> peak_bytes = 0;

constexpr std::size_t kPrefix = alignof(std::max_align_t);

}  // namespace

void* operator new(std::size_t size) {
  void* const block = std::malloc(size + kPrefix);
  if (block == nullptr) throw std::bad_alloc();
  *static_cast<std::size_t*>(block) = size;
  peak_bytes = std::max<std::size_t>(peak_bytes, live_bytes += size);
  return static_cast<char*>(block) + kPrefix;
}

void operator delete(void* at) noexcept {
  if (at == nullptr) return;
  char* const block = static_cast<char*>(at) - kPrefix;
  live_bytes -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}

void operator delete(void* at, std::size_t) noexcept { operator delete(at); }

namespace tetsculpt {
namespace {

// Bytes of memory for a byte of the file: a point of 3 bytes takes 24, and a vector that grows has
// up to three times its values; a run of LZF is 88 times as long as its bytes.
constexpr std::size_t kFactor = 100;
constexpr std::size_t kFloor = 100'000;

// The parser reads or refuses, within the memory. True if it reads.
bool reads(const std::string& path, std::string_view content) {
  const std::size_t before = live_bytes;
  peak_bytes = before;
  bool read = true;
  try {
    parse_points(content, path);
  } catch (const IoError&) {
    read = false;
  }
  CHECK(peak_bytes - before < kFloor + kFactor * content.size());
  return read;
}

const std::string kHuge[] = {"4000000000", "1000000000000000000", "18446744073709551615"};

TEST_CASE("counts of points") {
  for (const std::string& count : kHuge) {
    CAPTURE(count);
    CHECK_FALSE(reads("a.pts", count + "\n1 2 3\n"));
    CHECK_FALSE(reads("a.off", "OFF " + count + " 0 0\n1 2 3\n"));
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
      for (const char* more : {"", "property list uchar int l\n", "property double w\n"}) {
        CHECK_FALSE(reads("a.ply", std::string("ply\nformat ") + format + " 1.0\nelement vertex " +
                                       count +
                                       "\nproperty uchar x\nproperty uchar y\nproperty uchar z\n" +
                                       more + "end_header\n1 2 3 0 1\n"));
      }
    }
    for (const char* data : {"ascii", "binary", "binary_compressed"}) {
      CHECK_FALSE(reads("a.pcd", "FIELDS x y z\nSIZE 1 1 1\nTYPE U U U\nPOINTS " + count +
                                     "\nDATA " + data + "\n1 2 3\n1 2 3 4 5 6 7 8 9\n"));
    }
    for (const char* format : {"ASCII", "BINARY"}) {
      const std::string begin =
          std::string("# vtk DataFile Version 3.0\n\n") + format + "\nDATASET POLYDATA\n";
      CHECK_FALSE(reads("a.vtk", begin + "POINTS " + count + " char\n1 2 3\n"));
      CHECK_FALSE(reads("a.vtk", begin + "POINTS 0 char\n\nPOLYGONS 1 " + count + "\n"));
      CHECK_FALSE(reads("a.vtk", begin + "POINTS 0 char\n\nPOINT_DATA 0\nFIELD f " + count + "\n"));
      CHECK_FALSE(reads(
          "a.vtk", begin + "POINTS 0 char\n\nPOINT_DATA 0\nFIELD f 1\na " + count + " 0 int\n"));
    }
  }
}

TEST_CASE("counts in binary headers") {
  testing::Las las;
  las.records = testing::las_record(20, {1, 2, 3});
  las.short_count = 4'000'000'000U;
  CHECK_FALSE(reads("a.las", testing::las_bytes(las)));
  CHECK_FALSE(reads("a.stl", std::string(80, ' ') + "\xFF\xFF\xFF\xFF" + std::string(50, '\0')));
  for (const std::uint32_t whole : {12U, 4'294'967'292U}) {
    std::string file = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS " +
                       std::to_string(whole / 12) + "\nDATA binary_compressed\n";
    for (const std::uint32_t size : {3U, whole}) file += testing::bytes(size, std::endian::little);
    CHECK_FALSE(reads("a.pcd", file + "\x01"
                                      "ab"));
  }
}

// A line of `part` again and again, by every reader of lines.
void check_long_lines(std::string_view part, std::size_t size) {
  CAPTURE(part);
  const auto line = [&](std::string text) {
    while (text.size() < size) text += part;
    return text;
  };
  for (const char* path : {"a.xyz", "a.stl", "a.pcd", "a.ply", "a"}) reads(path, line(""));
  reads("a.obj", line("v "));
  reads("a.off", line("OFF 1 0 0\n"));
  reads("a.csv", line("//X,Y,Z,") + "\n1,2,3\n");
  reads("a.csv", line("x,y,z,") + "\n1,2,3\n");
  reads("a.pcd", line("FIELDS x y z "));
  reads("a.vtk", line("# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 9 int\n"));
}

TEST_CASE("long lines") {
  constexpr std::size_t kLong = testing::random_cases(10'000'000);
  for (const std::string_view part : {"1 ", ",a"}) check_long_lines(part, kLong);
  for (const std::string_view part : {"1", "a", ",", " ", "1,", "a ", "\"", "# ", "\r"}) {
    check_long_lines(part, kLong / 30);
  }
  CHECK_FALSE(reads("a.xyz", std::string(kLong, '1')));
}

TEST_CASE("many columns") {
  std::string titles = "x y z";
  std::string row = "1 2 3";
  for (int i = 3; i < 1000; ++i) {
    titles += " a";
    row += " 4";
  }
  CHECK(parse_points(titles + "\n" + row + "\n", "a.xyz").attributes.size() == 997);
  CHECK_FALSE(reads("a.xyz", row + " 5\n"));
}

}  // namespace
}  // namespace tetsculpt
