// Segments, dots and colours of faces in a picture: where they are seen, and how large.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "io/picture.h"
#include "tests/support/io_scenes.h"

namespace tetsculpt {
namespace {

using testing::count_pixels;
using testing::middle;

constexpr Colour kGreen = {0, 160, 0};

bool green(const Colour& c) { return c.g > c.r + 60 && c.g > c.b + 60; }

/// The area under green on white, in pixels.
double green_area(const Image& image) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) sum += 255U - image.rgb[i];
  return static_cast<double>(sum) / 255;
}

/// From the middle of a face of the cube, at this angle.
Image cube_with_dot(const Point3& dot, double azimuth, double elevation) {
  const TriangleMesh cube = testing::cube();
  return draw({.mesh = &cube, .dots = {{{dot}, kGreen, 4}}},
              {.azimuth = azimuth, .elevation = elevation, .width = 120, .height = 120});
}

TEST_CASE("azimuth and elevation: which face of a cube is seen") {
  struct Case {
    Point3 dot;
    double azimuth;
    double elevation;
  };
  for (const Case& c :
       {Case{{1, 0, 0}, 0, 0}, Case{{0, 1, 0}, 90, 0}, Case{{-1, 0, 0}, 180, 0},
        Case{{0, -1, 0}, -90, 0}, Case{{0, 0, 1}, 0, 90}, Case{{0, 0, -1}, 0, -90}}) {
    INFO(c.azimuth, " ", c.elevation);
    CHECK(middle(cube_with_dot(c.dot, c.azimuth, c.elevation)) == kGreen);
    CHECK(middle(cube_with_dot(c.dot, c.azimuth + 360, c.elevation)) == kGreen);
    CHECK(count_pixels(cube_with_dot(c.dot, c.azimuth + 180, -c.elevation), green) == 0);
  }
  const Image right = cube_with_dot({0, 1, 0}, 45, 0);  // x to the left, y to the right
  std::size_t on_the_right = 0;
  for (std::size_t y = 0; y < 120; ++y) {
    for (std::size_t x = 60; x < 120; ++x) on_the_right += green(testing::pixel(right, x, y));
  }
  CHECK(on_the_right > 30);
  CHECK(count_pixels(right, green) == on_the_right);
}

TEST_CASE("dots and segments are as large as they say") {
  for (const double radius : {1.0, 3.0, 10.0, 30.0}) {
    const Image image =
        draw({.dots = {{{{1, 2, 3}}, kGreen, radius}}}, {.width = 80, .height = 90});
    const double area = 3.1416 * radius * radius;
    CHECK(std::abs(green_area(image) - area) < 0.02 * area + 0.5);
  }
  for (const double width : {2.0, 5.0, 9.0}) {
    const std::vector<std::array<Point3, 2>> ends = {{{{0, 0, 0}, {0, 1, 0}}}};
    const Image image = draw({.segments = {{ends, kGreen, width}}},
                             {.azimuth = 0, .elevation = 0, .width = 300, .height = 100});
    // The margin is a twenty-fifth of the height on each side; a row of samples more or less.
    const double area = 292 * width + 3.1416 / 4 * width * width;
    CHECK(std::abs(green_area(image) - area) < 292.0 / 3 + 3);
  }
}

TEST_CASE("a segment of any direction is one connected stroke") {
  for (int degrees = 0; degrees < 180; degrees += 15) {
    const double angle = degrees * 3.14159265358979 / 180;
    const Point3 end = {0, 100 * std::cos(angle), 100 * std::sin(angle)};
    const std::vector<std::array<Point3, 2>> ends = {{{{0, -end.y, -end.z}, end}}};
    const Image image = draw({.segments = {{ends, kGreen, 4}}},
                             {.azimuth = 0, .elevation = 0, .width = 100, .height = 100});
    INFO(degrees);
    const double longer = std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
    const double area = 4 * 92 / longer;
    CHECK(std::abs(green_area(image) - area) < 0.04 * area);
    CHECK(middle(image) == kGreen);
  }
}

TEST_CASE("edges of the surface are seen in front and hidden behind") {
  const TriangleMesh cube = testing::cube();
  // The twelve edges, nine of which are seen; and one inside.
  Segments all{{}, kGreen, 2};
  Segments front{{}, kGreen, 2};
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (const std::uint32_t bit : {1U, 2U, 4U}) {
      if ((i & bit) != 0) continue;
      all.ends.push_back({cube.points[i], cube.points[i | bit]});
      if (i != 0) front.ends.push_back(all.ends.back());  // those at corner 0 are behind
    }
  }
  all.ends.push_back({Point3{-0.5, 0, 0}, Point3{0.5, 0.5, 0}});
  const View view{.width = 200, .height = 200};
  const Image with_all = draw({.mesh = &cube, .segments = {all}}, view);
  const Image with_front = draw({.mesh = &cube, .segments = {front}}, view);
  CHECK(count_pixels(with_front, green) > 1500);
  const auto seen = [](const Image& image) { return double(count_pixels(image, green)); };
  CHECK(seen(with_all) - seen(with_front) < 0.01 * seen(with_front));
  const Image bare = draw({.segments = {front}}, view);
  CHECK(seen(with_front) > 0.95 * seen(bare));
}

TEST_CASE("faces in their own colours, tinted from the back") {
  const TriangleMesh cube = testing::cube();
  std::vector<Colour> colours(12, Colour{200, 200, 0});
  colours[10] = colours[11] = {0, 200, 0};  // x = 1
  const View view{.azimuth = 0, .elevation = 0, .width = 90, .height = 90};
  const Image front = draw({.mesh = &cube, .face_colours = colours}, view);
  CHECK(green(middle(front)));
  CHECK(middle(front).b == 0);
  const TriangleMesh turned = testing::inside_out(cube);
  CHECK(testing::reddish(middle(draw({.mesh = &turned, .face_colours = colours}, view))));
}

}  // namespace
}  // namespace tetsculpt
