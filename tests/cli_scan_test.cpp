// A real scan through the whole program.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/read_points.h"
#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

using testing::TempDir;

constexpr const char* kKitten = TETSCULPT_SOURCE_DIR "/tests/data/kitten.xyz";

/// Reconstructs the kitten, checks all but the number of its points, and returns the surface.
TriangleMesh kitten(const TempDir& dir, const std::string& criterion, int status) {
  const testing::Run run = testing::run(
      dir, {"--method", "paper", "--criterion", criterion, "-q", kKitten, "kitten.off"});
  CHECK(run.status == status);
  CHECK(run.out.empty());
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
    CHECK(kitten(dir, criterion, 0).points == read_points(kKitten).points);
  }
}

// Going for the least change of area gets stuck with nine points inside.
TEST_CASE("the kitten by area: closed and manifold, few points hidden") {
  const TempDir dir;
  const std::size_t all = read_points(kKitten).points.size();
  const std::size_t reached = kitten(dir, "area", 4).points.size();
  CHECK(reached < all);
  CHECK(reached > all - 20);
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
