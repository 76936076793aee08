// Whatever the bytes of a file are: it is read, or refused with an IoError.
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "io/io_error.h"
#include "io/obj_reader.h"
#include "io/off_reader.h"
#include "io/ply_reader.h"
#include "io/text_points.h"
#include "tests/support/io_ply_bytes.h"

namespace tetsculpt {
namespace {

using testing::bytes;
using testing::ply_header;

constexpr int kMutations = 20'000;  // of each file
constexpr std::uint64_t kSeed = 77;

// Small counts, so that most of the numbers in a file matter.
constexpr std::string_view kElements =
    "element a 2\nproperty list uchar short i\nelement vertex 3\nproperty float x\n"
    "property double y\nproperty list char uchar w\nproperty int z\n";

std::string binary_ply(std::endian order, std::string_view format) {
  std::string file = ply_header(format, kElements);
  for (const std::int16_t item : {std::int16_t{4}, std::int16_t{-5}}) {
    file += bytes(std::uint8_t{1}, order) + bytes(item, order);
  }
  for (const std::int32_t z : {7, -8, 9}) {
    file += bytes(0.5F, order) + bytes(0.1, order) + "\x02vw" + bytes(z, order);
  }
  return file;
}

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string mutated(std::string file) {
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(file);
    return file;
  }

 private:
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_() % limit); }

  void change(std::string& file) {
    constexpr std::string_view kTelling = "\n\r\t ,;#/-+.eE0159\xFF\x7F\x80naif\0";
    const std::size_t at = below(file.size() + 1);
    const std::size_t length = below(8);
    switch (below(6)) {
      case 0:
        if (at < file.size()) file[at] = static_cast<char>(file[at] ^ (1 << below(8)));
        break;
      case 1:
        file.resize(at);
        break;
      case 2:
        file.insert(at, 1 + length, static_cast<char>(below(256)));
        break;
      case 3:
        file.insert(at, 1, kTelling[below(kTelling.size())]);
        break;
      case 4:
        file.erase(at, length);
        break;
      default:
        file.insert(at, file.substr(below(file.size() + 1), 4 * length));
    }
  }

  std::mt19937_64 random_;
};

// Runs `parse` over mutations of `file`; true if some were read and some refused.
template <typename Parse>
bool survives(const std::string& file, Parse parse) {
  Mutator mutator(kSeed);
  int read = 0;
  int refused = 0;
  parse(file, "valid");
  for (int i = 0; i < kMutations; ++i) {
    const std::string content = mutator.mutated(file);
    try {
      parse(content, "mutated");
      ++read;
    } catch (const IoError&) {
      ++refused;
    } catch (const std::exception& other) {
      FAIL("seed " << kSeed << ", mutation " << i << ": " << other.what());
    }
  }
  return read > 0 && refused > 0;
}

TEST_CASE("text") {
  const auto parse = [](std::string_view text, const std::filesystem::path& path) {
    return parse_text_points(text, path);
  };
  CHECK(survives("x,y,z\n2\n0.1,-2e5,3;\r\n# c\n 4\t5 nan 7\n", parse));
  CHECK(survives("//b;g;r;z;y;x\n2\n0;1;2;3;4;5\n0;;200;3;4;5\n", parse));
}

TEST_CASE("obj") { CHECK(survives("# c\nv 0 1.5 -2\nvn 0 0 1\nv 1 2 3 4\n", parse_obj_points)); }

TEST_CASE("off") { CHECK(survives("COFF 2 1 0 # c\n0 1 2 9\n\n1 1 1 9\n", parse_off_points)); }

TEST_CASE("ply ascii") {
  CHECK(survives(
      ply_header("ascii", kElements) + "1 7\n0\n0.5 0.1 2 9 9 7\n1 2 0 3\n\n-1 -2 1 8 -3\n",
      parse_ply_points));
}

TEST_CASE("ply binary") {
  CHECK(survives(binary_ply(std::endian::little, "binary_little_endian"), parse_ply_points));
  CHECK(survives(binary_ply(std::endian::big, "binary_big_endian"), parse_ply_points));
}

}  // namespace
}  // namespace tetsculpt
