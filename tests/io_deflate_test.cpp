// A zlib stream, read back by a reader written from the standard, gives the bytes that went in; and
// each form of block is taken where it is the shortest.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/deflate.h"
#include "tests/support/io_inflate.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using testing::Inflated;
using testing::inflated;

std::string noise(std::size_t size, std::uint64_t seed, std::size_t letters = 256) {
  point_sets::Random random(seed);
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<char>(random.below(letters)));
  return bytes;
}

Inflated round_trip(const std::string& bytes) {
  const std::string stream = zlib_stream(bytes);
  INFO(bytes.size(), " bytes as ", stream.size());
  const Inflated back = inflated(stream);
  CHECK(back.bytes == bytes);
  CHECK(stream.size() <= bytes.size() + 12 + 6 * (bytes.size() / 32768));
  CHECK(zlib_stream(bytes) == stream);
  return back;
}

TEST_CASE("short ones") {
  CHECK(zlib_stream("") == std::string("\x78\x9c\x03\x00\x00\x00\x00\x01", 8));
  for (std::size_t size = 0; size < 40; ++size) {
    round_trip(noise(size, size));
    round_trip(noise(size, size, 2));
    round_trip(std::string(size, '\xff'));
  }
}

TEST_CASE("a run, at every length about the longest repeat") {
  for (std::size_t size = 250; size < 270; ++size) round_trip(std::string(size, 'a'));
  for (std::size_t size = 510; size < 530; ++size) round_trip("b" + std::string(size, 'a') + "b");
  const std::string run(1'000'000, '\0');
  round_trip(run);
  CHECK(zlib_stream(run).size() < 1100);  // 258 bytes in two bits
}

TEST_CASE("repeats of every length, and distances up to the window") {
  std::string lengths;
  const std::string text = noise(300, 1);
  for (std::size_t n = 3; n <= 259; ++n) lengths += text.substr(0, n) + noise(2, n);
  round_trip(lengths);
  for (const std::size_t distance :
       std::initializer_list<std::size_t>{1, 2, 3, 4, 5, 7, 24, 25, 96, 97, 1024, 1025, 12288,
                                          12289, 24577, 32767, 32768, 32769}) {
    INFO(distance);
    const std::string bytes = noise(distance, distance);
    const std::string twice = bytes + bytes.substr(0, std::min<std::size_t>(distance, 200));
    round_trip(twice);
    const bool found = zlib_stream(twice).size() < distance + 100;
    if (distance > 200) CHECK(found == (distance <= 32768));
  }
}

TEST_CASE("the shortest of the three forms") {
  CHECK(round_trip(noise(100'000, 2)).blocks == std::array{4, 0, 0});  // does not compress
  CHECK(round_trip("a little text").blocks == std::array{0, 1, 0});
  CHECK(round_trip(noise(20'000, 3, 5)).blocks == std::array{0, 0, 1});
  const Inflated mixed =
      round_trip(noise(32'768, 4) + noise(200'000, 5, 3) + noise(70'000, 6) + "the end");
  CHECK(mixed.blocks[0] > 0);
  CHECK(mixed.blocks[2] > 0);
}

TEST_CASE("few letters come near to their entropy") {
  CHECK(zlib_stream(noise(100'000, 7, 16)).size() < 60'000);  // repeats of 3 and 4 cost a little
  CHECK(zlib_stream(noise(100'000, 8, 2)).size() < 18'000);
}

// Counts that grow like Fibonacci's numbers want words of up to 22 bits, and are to get 15.
TEST_CASE("words as long as the limit") {
  std::string bytes;
  std::size_t count = 1;
  for (std::size_t letter = 0, before = 0; letter < 22; ++letter) {
    bytes.append(count, static_cast<char>(11 * letter));
    count += std::exchange(before, count);
  }
  bytes.resize(30'000);
  point_sets::Random random(9);
  for (std::size_t i = bytes.size(); i-- > 1;) std::swap(bytes[i], bytes[random.below(i + 1)]);
  round_trip(bytes);
}

// All but a few: another repeat may have the same letters, or by chance the same sum.
TEST_CASE("the tests' reader refuses broken streams") {
  const std::string stream = zlib_stream(noise(3000, 10, 7));
  std::size_t refused = 0;
  for (std::size_t i = 0; i < stream.size(); ++i) {
    std::string broken = stream;
    broken[i] = static_cast<char>(broken[i] ^ 4);
    try {
      inflated(broken);
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  CHECK(refused > 98 * stream.size() / 100);
}

}  // namespace
}  // namespace tetsculpt
