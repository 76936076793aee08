// --picture draws the surface into a file, whole or not at all; --view and --up say from where.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/io_png.h"
#include "tests/support/io_scenes.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::bytes_of;
using testing::Run;
using testing::TempDir;

TEST_CASE("a picture of the right size that is not all white, and shows no inside") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(point_sets::ellipsoid(0.2, 1)));
  const Run run = testing::run(dir, {"--picture", "a.png", "a.xyz", "a.ply"});
  CHECK(run.status == 0);
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.ply", "a.png", "a.xyz"});
  const Image image = testing::image_of_png(bytes_of(dir.path() / "a.png"));
  CHECK(image.width == 800);
  CHECK(image.height == 600);
  CHECK_FALSE(testing::white(testing::middle(image)));
  CHECK(testing::white(testing::pixel(image, 0, 0)));
  CHECK(testing::count_pixels(image, testing::reddish) == 0);
}

TEST_CASE("the same command, the same picture; another view, another one") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(point_sets::ellipsoid(0.3, 1)));
  const auto picture = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--picture=a.png", "a.xyz", "a.ply"});
    CHECK(testing::run(dir, words).status == 0);
    return bytes_of(dir.path() / "a.png");
  };
  const std::string usual = picture({});
  CHECK(picture({"--threads", "3"}) == usual);
  CHECK(picture({"--view", "30,20", "--up", "z"}) == usual);
  CHECK(picture({"--view=-60.5,-90"}) != usual);
  CHECK(picture({"--view", "30,21"}) != usual);
  const std::string y_up = picture({"--up", "y"});
  CHECK(y_up != usual);
  CHECK(picture({"--up", "x"}) != y_up);
}

TEST_CASE("wrong usage") {
  const TempDir dir;
  dir.file("a.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const std::string angles = "is not AZIMUTH,ELEVATION in degrees, the elevation from -90 to 90";
  std::vector<std::pair<std::vector<std::string>, std::string>> lines{
      {{"a.xyz", "b.ply", "--picture"}, "--picture needs a value"},
      {{"a.xyz", "b.ply", "--picture="}, "--picture needs a file"},
      {{"a.xyz", "b.ply", "--picture", "b.jpg"}, "b.jpg: unknown kind of picture; use .png"},
      {{"a.xyz", "b.ply", "--picture", "png"}, "png: unknown kind of picture; use .png"},
      {{"a.xyz", "b.ply", "--view", "1,2"}, "--view and --up need --picture or --viewer"},
      {{"a.xyz", "b.ply", "--up", "x"}, "--view and --up need --picture or --viewer"},
      {{"a.xyz", "b.ply", "--up", "w"}, "--up: 'w' is none of x, y, z"},
      {{"a.xyz", "b.png"},
       "b.png: unknown kind of output file; use .ply, .obj, .off, .stl, .wrl, .gltf, .glb or "
       ".vtk"}};
  for (const std::string word : {"", ",", "1", "1,", ",1", "1,2,3", "1;2", "a,b", "1,2x", "1, 2",
                                 "nan,0", "0,inf", "0,90.5", "0,-91", "1e999,0"}) {
    lines.push_back({{"--view", word, "--picture", "b.png", "a.xyz", "b.ply"},
                     "--view: '" + word + "' " + angles});
  }
  for (const auto& [words, message] : lines) {
    const Run run = testing::run(dir, words);
    CHECK(run.status == 1);
    CHECK(run.err == "tetsculpt: " + message + " ('tetsculpt --help' explains)\n");
  }
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.xyz"});
  CHECK(testing::run(dir, {"a.xyz", "b.ply", "--picture", "B.PNG"}).status == 0);
}

TEST_CASE("a picture that can't be written: status 5, and no trace of it") {
  const TempDir dir;
  dir.file("a.xyz", testing::xyz(point_sets::ellipsoid(0.3, 1)));
  const Run lost = testing::run(dir, {"--picture", "none/a.png", "a.xyz", "a.ply"});
  CHECK(lost.status == 5);
  CHECK(lost.err.starts_with("tetsculpt: none/a.png: cannot create: "));
  CHECK(testing::names_in(dir) == std::vector<std::string>{"a.xyz"});  // found before the work

  dir.file("old.png", "as it was");
  for (const std::string name : {"new.png", "old.png"}) {
    const Run cut =
        testing::run(dir, {"--picture", name, "a.xyz", "a.ply"}, "trap '' XFSZ; ulimit -f 20;");
    CHECK(cut.status == 5);
    CHECK(cut.err.starts_with("tetsculpt: " + name + ": cannot write: "));
    CHECK(testing::names_in(dir) == std::vector<std::string>{"a.ply", "a.xyz", "old.png"});
  }
  CHECK(bytes_of(dir.path() / "old.png") == "as it was");
  if (std::filesystem::exists("/dev/full")) {
    std::filesystem::create_symlink("/dev/full", dir.path() / "full.png");
    CHECK(testing::run(dir, {"--picture", "full.png", "a.xyz", "a.ply"}).status == 5);
  }
}

TEST_CASE("no surface, no picture") {
  const TempDir dir;
  dir.file("plane.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
  CHECK(testing::run(dir, {"--picture", "a.png", "plane.xyz", "a.ply"}).status == 3);
  CHECK(testing::run(dir, {"--picture", "a.png", "none.xyz", "a.ply"}).status == 2);
  CHECK(testing::names_in(dir) == std::vector<std::string>{"plane.xyz"});
}

}  // namespace
}  // namespace tetsculpt
