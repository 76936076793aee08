// The picture of a surface: what is seen of it, from where, and at any size of coordinates.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "io/picture.h"
#include "tests/support/io_scenes.h"

namespace tetsculpt {
namespace {

using testing::count_pixels;
using testing::middle;
using testing::pixel;
using testing::reddish;
using testing::white;

constexpr View kView{.width = 160, .height = 120};

Image picture(const TriangleMesh& mesh, const View& view = kView) {
  return draw({.mesh = &mesh}, view);
}

template <class Function>
TriangleMesh moved(TriangleMesh mesh, const Function& f) {
  for (Point3& p : mesh.points) p = f(p);
  return mesh;
}

std::size_t differences(const Image& a, const Image& b) {
  REQUIRE(a.rgb.size() == b.rgb.size());
  std::size_t n = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) n += a.rgb[i] != b.rgb[i] ? 1U : 0U;
  return n;
}

TEST_CASE("nothing is white") {
  for (const Image& image : {draw({}, kView), picture({}), picture({{{0, 0, 0}, {1, 0, 0}}, {}})}) {
    CHECK(image.width == 160);
    CHECK(image.height == 120);
    CHECK(image.rgb == std::vector<std::uint8_t>(3 * 160 * 120, 255));
  }
  CHECK(draw({}, {.width = 1, .height = 1}).rgb.size() == 3);
  CHECK_FALSE(white(middle(draw({.mesh = nullptr, .dots = {{{{5, 5, 5}}}}}, kView))));
}

TEST_CASE("as large as the picture can hold, with a margin") {
  for (const auto& [width, height] : {std::pair{200, 100}, std::pair{100, 200}, std::pair{5, 7}}) {
    const Image image = picture(testing::round_sphere(20),
                                {.width = std::size_t(width), .height = std::size_t(height)});
    const auto wide = [&](std::size_t y) { return !white(pixel(image, image.width / 2, y)); };
    const auto high = [&](std::size_t x) { return !white(pixel(image, x, image.height / 2)); };
    const bool flat = width > height;
    const std::size_t size = flat ? image.height : image.width;
    std::size_t covered = 0;
    for (std::size_t i = 0; i < size; ++i) covered += (flat ? wide(i) : high(i)) ? 1U : 0U;
    CHECK(covered >= 9 * size / 10);
    if (size > 20) CHECK(covered < size);
  }
}

TEST_CASE("a closed surface shows no back and no gap, inside out it shows nothing else") {
  for (const std::uint32_t n : {2U, 5U, 30U, 80U}) {
    const TriangleMesh sphere = testing::round_sphere(n);
    for (const double azimuth : {0.0, 45.0, 77.0}) {
      for (const double elevation : {-90.0, -30.0, 0.0, 20.0, 90.0}) {
        INFO(n, " ", azimuth, " ", elevation);
        const View view{.azimuth = azimuth, .elevation = elevation, .width = 90, .height = 90};
        const Image image = picture(sphere, view);
        CHECK(count_pixels(image, reddish) == 0);
        const Image turned = picture(testing::inside_out(sphere), view);
        const std::size_t covered = count_pixels(image, [](Colour c) { return !white(c); });
        CHECK(count_pixels(turned, reddish) > covered * 9 / 10);
        if (n < 30) continue;
        for (std::size_t i = 15; i < 75; ++i) CHECK_FALSE(white(pixel(image, i, 45)));
        CHECK(covered > 5000);
      }
    }
  }
}

TEST_CASE("into an open surface one sees the red of its inside") {
  TriangleMesh open = testing::cube();
  open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);  // the top
  CHECK(count_pixels(picture(open, {.elevation = 60, .width = 90, .height = 90}), reddish) > 500);
  CHECK(count_pixels(picture(open, {.elevation = -60, .width = 90, .height = 90}), reddish) == 0);
}

TEST_CASE("any size of coordinates, any place") {
  const TriangleMesh sphere = testing::round_sphere(8);
  const Image expected = picture(sphere);
  for (const int exponent : {-1000, -500, -1, 1, 500, 1022}) {
    const auto scaled = [&](double x) { return std::scalbn(x, exponent); };
    const Image image = picture(moved(sphere, [&](Point3 p) {
      return Point3{scaled(p.x), scaled(p.y), scaled(p.z)};
    }));
    CHECK(image.rgb == expected.rgb);
  }
  for (const double size : {std::numeric_limits<double>::max(), 1e150, 1e-150, 5e-322}) {
    const Image image = picture(moved(testing::cube(), [&](Point3 p) {
      return Point3{size * p.x, size * p.y, size * p.z};
    }));
    CHECK(differences(image, picture(testing::cube())) < 300);
  }
  const Image far = picture(moved(testing::cube(), [](Point3 p) {
    return Point3{p.x + 1e12, p.y - 1e12, p.z + 1e11};
  }));
  CHECK(differences(far, picture(testing::cube())) < 300);
}

TEST_CASE("triangles without area change nothing") {
  TriangleMesh mesh = testing::cube();
  const Image expected = picture(mesh);
  mesh.points.push_back({0, 0, 1});
  mesh.triangles.insert(mesh.triangles.end(), {{0, 0, 0}, {1, 1, 5}, {4, 7, 8}});
  CHECK(picture(mesh).rgb == expected.rgb);
}

TEST_CASE("the upright axis: the scene with its coordinates shifted is the same picture") {
  const TriangleMesh mesh = moved(testing::round_sphere(8), [](Point3 p) {
    return Point3{p.x + p.z * p.z, 2 * p.y, p.z + (p.x > 0.5 ? p.x : 0)};
  });
  const Image expected = picture(mesh);
  View view = kView;
  view.up = UpAxis::kX;
  const Image x = picture(moved(mesh, [](Point3 p) { return Point3{p.z, p.x, p.y}; }), view);
  CHECK(differences(x, expected) < 300);
  view.up = UpAxis::kY;
  const Image y = picture(moved(mesh, [](Point3 p) { return Point3{p.y, p.z, p.x}; }), view);
  CHECK(differences(y, expected) < 300);
  CHECK(differences(picture(mesh, view), expected) > 3000);
}

TEST_CASE("the headlight: what faces the eye is the brightest") {
  const TriangleMesh sphere = testing::round_sphere(60);
  const Image image = picture(sphere, {.width = 100, .height = 100});
  CHECK(middle(image).g > 170);
  CHECK(pixel(image, 90, 50).g < middle(image).g - 30);
  CHECK(pixel(image, 50, 90).g < pixel(image, 50, 10).g);  // the other light is above
}

}  // namespace
}  // namespace tetsculpt
