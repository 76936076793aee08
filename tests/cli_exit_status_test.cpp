// Each exit status the help text lists, and what the program says with it.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/sculpt_cli.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::Run;
using testing::TempDir;

constexpr std::string_view kTetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

/// A run on a file points.xyz with this content.
Run run_on(const TempDir& dir, std::string_view content, std::vector<std::string> options = {}) {
  dir.file("points.xyz", content);
  options.insert(options.end(), {"--method", "paper", "points.xyz", "surface.off"});
  return testing::run(dir, options);
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// A failure says so on stderr in one line, says nothing on stdout, and makes no file.
void check_failure(const Run& run, int status, std::string_view message) {
  INFO("stderr: ", run.err);
  CHECK(run.status == status);
  CHECK(run.out.empty());
  CHECK(run.err == "tetsculpt: " + std::string(message) + "\n");
}

TEST_CASE("0: done, with one line on stderr") {
  const TempDir dir;
  const Run run = run_on(dir, kTetrahedron);
  CHECK(run.status == 0);
  CHECK(run.out.empty());
  CHECK(run.err ==
        "surface.off: 4 triangles through 4 points; closed, manifold, genus 0, 1 component\n");
  CHECK_FALSE(broken_invariant(testing::mesh_of_off(dir.path() / "surface.off")));
}

TEST_CASE("2: a NaN is named by its index, and may be skipped") {
  const TempDir dir;
  const std::string content = "nan 0 0\n" + std::string(kTetrahedron) + "1 inf 1\n";
  check_failure(run_on(dir, content), 2,
                "points.xyz: point 0: a coordinate is not a finite number (points count from 0; "
                "--skip-invalid drops it)");
  check_failure(run_on(dir, std::string(kTetrahedron) + "1 1 -inf\n"), 2,
                "points.xyz: point 4: a coordinate is not a finite number (points count from 0; "
                "--skip-invalid drops it)");
  const Run skipping = run_on(dir, content, {"--skip-invalid"});
  CHECK(skipping.status == 0);
  CHECK(contains(skipping.err, "4 points, 2 invalid points skipped;"));
  CHECK(testing::mesh_of_off(dir.path() / "surface.off").points.size() == 4);
}

TEST_CASE("2: what --skip-invalid can't drop") {
  const TempDir dir;
  const std::string content = std::string(kTetrahedron) + "1e300 1 1\n1 1 1e-300\n";
  const Run run = run_on(dir, content, {"--skip-invalid"});
  CHECK(run.status == 2);
  CHECK(run.err.starts_with("tetsculpt: points.xyz: point "));
  CHECK(run.err.ends_with("(points count from 0)\n"));
}

TEST_CASE("2: a file that is not there, is no file, or is broken") {
  const TempDir dir;
  const auto read = [&](const char* name) {
    return testing::run(dir, {"--method", "paper", name, "surface.off"});
  };
  check_failure(read("none.xyz"), 2, "none.xyz: cannot open: No such file or directory");
  std::filesystem::create_directory(dir.path() / "folder.xyz");
  check_failure(read("folder.xyz"), 2, "folder.xyz: is a directory");
  dir.file("points.doc", "Dear reader\n");
  check_failure(read("points.doc"), 2,
                "points.doc: not a known kind of point file, nor is the extension '.doc' (known: "
                ".xyz .txt .csv .pts .asc .ply .obj .off .stl .pcd .las .vtk)");
  dir.file("broken.xyz", "0 0 0\n1 0\n");
  const Run broken = read("broken.xyz");
  CHECK(broken.status == 2);
  CHECK(broken.err.starts_with("tetsculpt: broken.xyz:2: "));
}

TEST_CASE("3: the points span no solid") {
  const TempDir dir;
  check_failure(run_on(dir, ""), 3, "points.xyz: no points; a solid needs at least 4");
  check_failure(run_on(dir, "nan 0 0\n", {"--skip-invalid"}), 3,
                "points.xyz: no points; a solid needs at least 4");
  check_failure(run_on(dir, "1 2 3\n1 2 3\n"), 3,
                "points.xyz: only one distinct point; a solid needs at least 4");
  check_failure(run_on(dir, "0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4\n"), 3,
                "points.xyz: 5 distinct points, all on one line: they span no solid");
  check_failure(run_on(dir, "0 0 0\n1 0 0\n0 1 0\n1 1 0\n"), 3,
                "points.xyz: 4 distinct points, all in one plane: they span no solid");
}

TEST_CASE("4: a surface, but not through every point; quiet or not they are named") {
  const TempDir dir;
  const auto points = testing::set_with_hidden_point();
  const std::string content = testing::xyz(points);
  const Run run = run_on(dir, content, {"-q"});
  CHECK(run.status == 4);
  const TriangleMesh mesh = testing::mesh_of_off(dir.path() / "surface.off");
  CHECK(mesh.points.size() == points.size() - 1);
  CHECK_FALSE(broken_invariant(mesh));
  const std::string saying = "tetsculpt: not on the surface, 1 in sum, points counted from 0: ";
  REQUIRE(run.err.starts_with(saying));
  const std::size_t hidden = std::stoul(run.err.substr(saying.size()));
  CHECK(std::ranges::count(mesh.points, points.at(hidden)) == 0);
  // Skipped points count.
  const Run shifted = run_on(dir, "nan nan nan\n" + content, {"-q", "--skip-invalid"});
  CHECK(shifted.status == 4);
  CHECK(shifted.err == saying + std::to_string(hidden + 1) + "\n");
}

TEST_CASE("5: the output can't be written") {
  const TempDir dir;
  dir.file("points.xyz", kTetrahedron);
  const auto write = [&](const char* name) {
    return testing::run(dir, {"--method", "paper", "points.xyz", name});
  };
  const Run nowhere = write("/nonexistent/folder/surface.ply");
  check_failure(nowhere, 5,
                "/nonexistent/folder/surface.ply: cannot create: No such file or directory");
  std::filesystem::create_directory(dir.path() / "folder.ply");
  const Run folder = write("folder.ply");
  CHECK(folder.status == 5);
  CHECK(folder.err.starts_with("tetsculpt: folder.ply: "));
  CHECK(testing::names_in(dir) == std::vector<std::string>{"folder.ply", "points.xyz"});
}

}  // namespace
}  // namespace tetsculpt
