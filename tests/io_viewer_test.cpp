// The viewer's page: one file that asks for nothing else, holds the arrays, and shows any name.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/base64.h"
#include "io/byte_order.h"
#include "io/viewer_page.h"
#include "io/viewer_writer.h"
#include "tests/support/io_files.h"
#include "tests/support/io_scenes.h"

namespace tetsculpt {
namespace {

using testing::TempDir;

/// By the definition of RFC 4648, a digit at a time.
std::string decoded(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  REQUIRE(text.size() % 4 == 0);
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text.substr(0, text.find('='))) {
    REQUIRE(kDigits.find(c) != std::string_view::npos);
    bits = bits << 6 | static_cast<std::uint32_t>(kDigits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

std::string bytes_of_array(std::string_view page, const std::string& id) {
  const std::string open = "<script type=\"text/plain\" id=\"" + id + "-data\">";
  const std::size_t start = page.find(open) + open.size();
  REQUIRE(start > open.size());
  return decoded(page.substr(start, page.find('<', start) - start));
}

std::vector<float> positions_in(std::string_view page) {
  const std::string bytes = bytes_of_array(page, "positions");
  std::vector<float> numbers;
  for (std::size_t at = 0; at < bytes.size(); at += 4) {
    numbers.push_back(load_number<float>(bytes.data() + at, std::endian::little));
  }
  return numbers;
}

/// Differences, two for each step up and one less for each step down, seven bits to a byte.
std::vector<std::uint32_t> integers_in(std::string_view page, const std::string& id) {
  std::vector<std::uint32_t> numbers;
  std::uint64_t told = 0;
  int shift = 0;
  std::int64_t last = 0;
  for (const char c : bytes_of_array(page, id)) {
    told |= static_cast<std::uint64_t>(c & 0x7f) << shift;
    shift += 7;
    if ((c & 0x80) != 0) continue;
    const auto half = static_cast<std::int64_t>(told / 2);
    last += told % 2 == 0 ? half : -half - 1;
    numbers.push_back(static_cast<std::uint32_t>(last & 0xffffffff));
    told = 0;
    shift = 0;
  }
  CHECK(shift == 0);
  return numbers;
}

SculptingRecord still(const TriangleMesh& mesh) {
  const std::size_t n = mesh.triangles.size();
  return {mesh.triangles, std::vector<std::uint32_t>(n, 0),
          std::vector<std::uint32_t>(n, SculptingRecord::kNever), 0};
}

std::string written(const ViewerScene& scene, const ViewerOptions& options = {}) {
  const TempDir dir;
  write_viewer(scene, dir.path() / "a.html", options);
  return testing::bytes_of(dir.path() / "a.html");
}

TEST_CASE("base64 as in RFC 4648, and back") {
  const std::array<std::string_view, 7> bytes{"", "f", "fo", "foo", "foob", "fooba", "foobar"};
  const std::array<std::string_view, 7> texts{"",         "Zg==",     "Zm8=",    "Zm9v",
                                              "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
  for (std::size_t i = 0; i < bytes.size(); ++i) CHECK(base64(bytes[i]) == texts[i]);
  std::string all;
  for (int i = 0; i < 1000; ++i) {
    all += static_cast<char>(i * i % 251 ^ i);
    REQUIRE(decoded(base64(all)) == all);
  }
}

TEST_CASE("the page asks for nothing from elsewhere, and nothing of its template is left") {
  const TriangleMesh mesh = testing::cube();
  const SculptingRecord record = still(mesh);
  const std::string page = written({.title = "cube", .points = mesh.points, .record = &record});
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(page.ends_with("</html>\n"));
  for (const std::string_view word :
       {"http", "//cdn", "import ", "@import", "url(", "src=", "{{", "}}\n{{"}) {
    INFO(word);
    CHECK(page.find(word) == std::string::npos);
  }
  CHECK(std::ranges::all_of(kViewerPage, [](char c) { return c > 0; }));
}

TEST_CASE("names are text, whatever is in them") {
  const TriangleMesh mesh = testing::cube();
  const SculptingRecord record = still(mesh);
  const std::string page = written({.title = "</title><script>\"&{{data}}",
                                    .facts = {{"<b>", "&amp;"}},
                                    .points = mesh.points,
                                    .record = &record});
  const std::string title = "&lt;/title&gt;&lt;script&gt;&quot;&amp;{{data}}";
  CHECK(page.find("<title>" + title + "</title>") != std::string::npos);
  CHECK(page.find("<h1>" + title + "</h1>") != std::string::npos);
  CHECK(page.find("<dt>&lt;b&gt;</dt><dd>&amp;amp;</dd>") != std::string::npos);
  CHECK(page.find("<b>", page.find("<dl>")) > page.find("</dl>"));
}

TEST_CASE("the arrays are in it, hidden points after the others") {
  const TriangleMesh mesh = testing::cube();
  SculptingRecord record = still(mesh);
  record.step_count = 3;
  record.born[1] = 2;
  record.died[0] = 3;
  const std::vector<Point3> hidden{{0, 0, 0.5}};
  const std::vector<std::array<std::uint32_t, 2>> tree{{0, 1}, {1, 8}};
  const std::vector<std::array<std::uint32_t, 3>> egh{{5, 6, 7}};
  const std::string page = written({.title = "cube",
                                    .points = mesh.points,
                                    .hidden = hidden,
                                    .record = &record,
                                    .emst_edges = tree,
                                    .egh_triangles = egh},
                                   {.view = {.azimuth = 0, .elevation = 0}});
  CHECK(page.find("{\"steps\": 3, \"hidden\": 1}") != std::string::npos);
  CHECK(integers_in(page, "emst") == std::vector<std::uint32_t>{0, 1, 1, 8});
  CHECK(integers_in(page, "egh") == std::vector<std::uint32_t>{5, 6, 7});
  CHECK(integers_in(page, "born") == record.born);
  CHECK(integers_in(page, "died") == record.died);
  const auto corners = integers_in(page, "triangles");
  REQUIRE(corners.size() == 36);
  for (std::size_t i = 0; i < 36; ++i) CHECK(corners[i] == mesh.triangles[i / 3][i % 3]);
  // Seen from +x: y to the right, z up, x towards the eye; half the diagonal is 1.
  const auto positions = positions_in(page);
  REQUIRE(positions.size() == 27);
  const double corner = 1 / std::sqrt(3.0);
  CHECK(positions[3 * 1 + 0] == doctest::Approx(-corner));
  CHECK(positions[3 * 1 + 2] == doctest::Approx(corner));
  CHECK(positions[3 * 8 + 1] == doctest::Approx(corner / 2));
}

TEST_CASE("positions far from the origin keep the digits that tell them apart") {
  TriangleMesh mesh = testing::cube();
  for (Point3& p : mesh.points) p = {p.x + 0x1p40, p.y * 0x1p-200, p.z - 0x1p40};
  const SculptingRecord record = still(mesh);
  const auto positions =
      positions_in(written({.title = "far", .points = mesh.points, .record = &record},
                           {.view = {.azimuth = 0, .elevation = 0}}));
  CHECK(positions[1] == doctest::Approx(-std::sqrt(0.5)));
  CHECK(positions[2] == doctest::Approx(-std::sqrt(0.5)));
  CHECK(positions[5] == doctest::Approx(std::sqrt(0.5)));
}

TEST_CASE("a long record is coarsened; no points at all are no fault") {
  const TriangleMesh mesh = testing::cube();
  SculptingRecord record = still(mesh);
  record.step_count = 4;
  for (std::uint32_t step = 1; step <= 3; ++step) {
    record.triangles.push_back({0, 1, 7});
    record.born.push_back(step);
    record.died.push_back(step + 1);
  }
  const ViewerScene scene{.title = "cube", .points = mesh.points, .record = &record};
  CHECK(integers_in(written(scene), "born").size() == 15);
  CHECK(integers_in(written(scene, {.most_passing_triangles = 0}), "born").size() == 12);
  const SculptingRecord none;
  CHECK(positions_in(written({.title = "", .record = &none})).empty());
}

TEST_CASE("a page that can't be written leaves no trace") {
  const TempDir dir;
  const SculptingRecord none;
  CHECK_THROWS_AS(write_viewer({.title = "", .record = &none}, dir.path() / "no" / "a.html"),
                  IoError);
}

}  // namespace
}  // namespace tetsculpt
