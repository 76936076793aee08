// The LZF decompressor: literals, copies that overlap, and refusal of everything broken.
#include <doctest/doctest.h>

#include <random>
#include <string>
#include <string_view>

#include "io/lzf.h"

namespace tetsculpt {
namespace {

using namespace std::string_view_literals;

TEST_CASE("literals") {
  CHECK(lzf_decompressed("", 0) == "");
  CHECK(lzf_decompressed("\0a"sv, 1) == "a");
  CHECK(lzf_decompressed("\2abc\1de"sv, 5) == "abcde");
  const std::string longest(32, 'q');
  CHECK(lzf_decompressed("\x1F" + longest, 32) == longest);
}

TEST_CASE("copies") {
  CHECK(lzf_decompressed("\2abc\x20\2"sv, 6) == "abcabc");       // 3 bytes from 3 back
  CHECK(lzf_decompressed("\0a\xC0\0"sv, 9) == "aaaaaaaaa");      // 8 bytes from 1 back
  CHECK(lzf_decompressed("\0a\xE0\0\0"sv, 10) == "aaaaaaaaaa");  // 9: the shortest long copy
  CHECK(lzf_decompressed("\0a\xE0\xFF\0"sv, 265) == std::string(265, 'a'));  // the longest
  CHECK(lzf_decompressed("\1ab\x40\1\0c\x20\0"sv, 10) == "abababcccc");
}

TEST_CASE("a copy from far back") {
  std::string packed;
  std::string plain;
  for (int i = 0; i < 256; ++i) {
    std::string part(32, static_cast<char>(i));
    part[7] = 'x';
    packed += '\x1F' + part;
    plain += part;
  }
  packed += "\x3F\xFF";  // 3 bytes from 8192 back
  CHECK(lzf_decompressed(packed, 8195) == plain + plain.substr(0, 3));
}

TEST_CASE("broken") {
  CHECK_FALSE(lzf_decompressed("\2ab"sv, 3));       // a literal cut off
  CHECK_FALSE(lzf_decompressed("\2abc\x20"sv, 6));  // a copy cut off
  CHECK_FALSE(lzf_decompressed("\2abc\xE0\1"sv, 6));
  CHECK_FALSE(lzf_decompressed("\2abc\x20\3"sv, 6));  // from before the begin
  CHECK_FALSE(lzf_decompressed("\x20\0"sv, 3));
  CHECK_FALSE(lzf_decompressed("\2abc"sv, 2));  // more or less than announced
  CHECK_FALSE(lzf_decompressed("\2abc"sv, 4));
  CHECK_FALSE(lzf_decompressed("\0a\xC0\0"sv, 8));
  CHECK_FALSE(lzf_decompressed("\0a\xC0\0"sv, std::size_t{1} << 62));
}

TEST_CASE("random bytes") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 100'000; ++i) {
    std::string bytes(random() % 20, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random() % 4 == 0 ? random() : random() % 3);
    const auto plain = lzf_decompressed(bytes, random() % 40);
    if (plain) REQUIRE(plain->size() < 40);
  }
}

}  // namespace
}  // namespace tetsculpt
