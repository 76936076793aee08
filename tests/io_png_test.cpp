// A PNG file, read back by a reader written from the standard, gives the picture that went in.
#include "tests/support/io_png.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "io/io_error.h"
#include "io/png_writer.h"
#include "tests/support/io_files.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

using testing::bytes_of;
using testing::TempDir;

/// A picture whose byte at x, y in channel c is f(x, y, c).
template <class Function>
Image picture(std::size_t width, std::size_t height, const Function& f) {
  Image image{width, height, {}};
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      for (std::size_t c = 0; c < 3; ++c)
        image.rgb.push_back(static_cast<std::uint8_t>(f(x, y, c)));
    }
  }
  return image;
}

Image noise(std::size_t width, std::size_t height) {
  point_sets::Random random(width + 1000 * height);
  return picture(width, height, [&](auto...) { return random.below(256); });
}

std::size_t round_trip(const Image& image) {
  const std::string file = png(image);
  INFO(image.width, " x ", image.height, ", ", file.size(), " bytes");
  const Image back = testing::image_of_png(file);
  CHECK(back.width == image.width);
  CHECK(back.height == image.height);
  CHECK(back.rgb == image.rgb);
  return file.size();
}

TEST_CASE("the smallest, byte for byte") {
  const std::string file = png({1, 1, {1, 2, 3}});
  REQUIRE(file.size() >= 57);
  CHECK(file.substr(0, 33) == std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\1\0\0\0\1"
                                          "\x08\2\0\0\0\x90\x77\x53\xde",
                                          33));
  CHECK(file.ends_with(std::string("\0\0\0\0IEND\xae\x42\x60\x82", 12)));
  round_trip({1, 1, {1, 2, 3}});
}

TEST_CASE("any size") {
  for (std::size_t width = 1; width < 12; ++width) {
    for (std::size_t height = 1; height < 12; ++height) round_trip(noise(width, height));
  }
  round_trip(noise(1, 5000));
  round_trip(noise(5000, 1));
  round_trip(noise(257, 129));
}

TEST_CASE("noise does not grow, one colour shrinks to nothing") {
  const std::size_t raw = 3 * 640 * 480;
  CHECK(round_trip(noise(640, 480)) < raw + 1000);
  for (const int value : {0, 1, 127, 255}) {
    CHECK(round_trip(picture(640, 480, [&](auto...) { return value; })) < 3000);
  }
}

TEST_CASE("every filter: what changes to the right, downwards, or both ways") {
  const auto size = [](const auto& f) { return round_trip(picture(200, 200, f)); };
  CHECK(size([](std::size_t x, std::size_t, std::size_t c) { return 3 * x + c; }) < 3000);
  CHECK(size([](std::size_t, std::size_t y, std::size_t c) { return 5 * y + 80 * c; }) < 3000);
  CHECK(size([](std::size_t x, std::size_t y, std::size_t) { return 3 * x + 7 * y; }) < 3000);
  CHECK(size([](std::size_t x, std::size_t y, std::size_t c) {
          return 128 + 90 * std::sin(0.02 * double(x + c)) * std::cos(0.03 * double(y));
        }) < 30'000);
}

TEST_CASE("more data than one chunk takes") { round_trip(noise(800, 600)); }

TEST_CASE("the file appears whole or not at all") {
  const TempDir dir;
  const Image image = noise(20, 10);
  write_png(image, dir.path() / "a.png");
  CHECK(bytes_of(dir.path() / "a.png") == png(image));
  CHECK_THROWS_AS(write_png(image, dir.path() / "none" / "a.png"), IoError);
  std::filesystem::create_directory(dir.path() / "b.png");
  CHECK_THROWS_AS(write_png(image, dir.path() / "b.png"), IoError);
  CHECK(std::distance(std::filesystem::directory_iterator(dir.path()), {}) == 2);
}

}  // namespace
}  // namespace tetsculpt
