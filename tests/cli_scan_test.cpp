// A real scan through the whole program.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "io/read_points.h"
#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

using testing::TempDir;

constexpr const char* kKitten = TETSCULPT_SOURCE_DIR "/tests/data/kitten.xyz";

/// The surface in kitten.off, after checks of all but its points.
TriangleMesh checked_mesh(const TempDir& dir) {
  TriangleMesh mesh = testing::mesh_of_off(dir.path() / "kitten.off");
  const auto wrong = broken_invariant(mesh);
  CHECK_MESSAGE(!wrong, *wrong);
  CHECK(std::ranges::count(testing::points_in_use(mesh), false) == 0);
  CHECK(topology(mesh).components == 1);
  CHECK(testing::signed_volume(mesh) > 0);
  return mesh;
}

TEST_CASE("the kitten: closed, manifold, oriented, through every point") {
  const TempDir dir;
  for (const std::string criterion : {"constrained", "longest", "gamma"}) {
    INFO(criterion);
    const testing::Run run = testing::run(dir, {"--method", "paper", "--criterion", criterion, "-q",
                                                "--no-attributes", kKitten, "kitten.off"});
    CHECK(run.status == 0);
    CHECK(run.out.empty());
    CHECK(run.err.empty());
    CHECK(checked_mesh(dir).points == read_points(kKitten).points);
  }
}

// Going for the least change of area gets stuck with nine points inside.
TEST_CASE("the kitten by area: closed and manifold, few points hidden, named in ascending order") {
  const TempDir dir;
  const testing::Run run =
      testing::run(dir, {"--method", "paper", "--criterion", "area", "-q", kKitten, "kitten.off"});
  CHECK(run.status == 4);
  const TriangleMesh mesh = checked_mesh(dir);
  std::istringstream words(run.err.substr(run.err.find("from 0:") + 7));
  const std::vector<std::size_t> hidden(std::istream_iterator<std::size_t>{words}, {});
  CHECK(hidden.size() > 1);
  CHECK(hidden.size() < 20);
  CHECK(std::ranges::is_sorted(hidden));
  std::vector<Point3> points = read_points(kKitten).points;
  for (auto i = hidden.rbegin(); i != hidden.rend(); ++i) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(*i));
  }
  CHECK(mesh.points == points);
}

TEST_CASE("the kitten: the same file whatever the number of threads") {
  const TempDir dir;
  for (const std::string threads : {"1", "2", "7"}) {
    const auto run = testing::run(dir, {"--method", "paper", "--threads", threads, "-q", kKitten,
                                        "kitten" + threads + ".ply"});
    REQUIRE(run.status == 0);
    CHECK(testing::bytes_of(dir.path() / ("kitten" + threads + ".ply")) ==
          testing::bytes_of(dir.path() / "kitten1.ply"));
  }
}

}  // namespace
}  // namespace tetsculpt
