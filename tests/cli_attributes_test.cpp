// Attributes of the input points go through the command to the surface's vertices.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/sculpt_cli.h"

namespace tetsculpt {
namespace {

using testing::bytes_of;
using testing::Run;
using testing::TempDir;

constexpr const char* kHead =
    "ply\nformat ascii 1.0\nelement vertex 6\nproperty uchar red\nproperty double x\n"
    "property double y\nproperty double z\nproperty uchar green\nproperty uchar blue\n"
    "property float nx\nproperty float ny\nproperty float nz\nproperty short level\n"
    "end_header\n";
// One is invalid, one is there twice.
constexpr const char* kRows =
    "1 nan 0 0 1 1 1 1 1 1\n"
    "2 0 0 0 20 200 -0.5 0.1 0 -2\n"
    "3 1 0 0 30 201 1 0 0 -3\n"
    "4 0 0 0 40 202 9 9 9 -4\n"
    "5 0 1 0 50 203 0 1 0 -5\n"
    "6 0 0 1 60 204 0 0 1 -6\n";

/// The text after "end_header".
std::string body(const std::string& text) {
  const std::string end = "end_header\n";
  return text.substr(text.find(end) + end.size());
}

TEST_CASE("ply to ply: each in its own type, of equal points the first, skipped ones left out") {
  const TempDir dir;
  dir.file("a.ply", std::string(kHead) + kRows);
  const Run run = testing::run(dir, {"-q", "--skip-invalid", "--ascii", "a.ply", "b.ply"});
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  const std::string text = bytes_of(dir.path() / "b.ply");
  for (const char* property : {"uchar red", "uchar green", "uchar blue", "float nx", "float ny",
                               "float nz", "short level"}) {
    CAPTURE(std::string(property));
    CHECK(text.find("property " + std::string(property) + "\n") != std::string::npos);
  }
  CHECK(
      body(text).starts_with("0 0 0 2 20 200 -0.5 0.1 0 -2\n1 0 0 3 30 201 1 0 0 -3\n"
                             "0 1 0 5 50 203 0 1 0 -5\n0 0 1 6 60 204 0 0 1 -6\n3 "));
}

TEST_CASE("to colours of an OFF file, with the rest reported") {
  const TempDir dir;
  dir.file("a.ply", std::string(kHead) + kRows);
  const Run run = testing::run(dir, {"-q", "--skip-invalid", "a.ply", "b.off"});
  CHECK(run.status == 0);
  CHECK(run.err == "tetsculpt: b.off: not in this format: level\n");
  const std::string text = bytes_of(dir.path() / "b.off");
  CHECK(text.starts_with("CNOFF\n"));
  CHECK(text.find("\n0 0 0 -0.5 0.1 0 2 20 200 255\n") != std::string::npos);
}

TEST_CASE("--no-attributes leaves them out") {
  const TempDir dir;
  dir.file("a.ply", std::string(kHead) + kRows);
  const Run run =
      testing::run(dir, {"-q", "--skip-invalid", "--no-attributes", "--ascii", "a.ply", "b.ply"});
  CHECK(run.status == 0);
  CHECK(run.err.empty());
  CHECK(body(bytes_of(dir.path() / "b.ply")).starts_with("0 0 0\n1 0 0\n0 1 0\n0 0 1\n"));
}

TEST_CASE("--normals replaces normals and says so") {
  const TempDir dir;
  dir.file("a.ply", std::string(kHead) + kRows);
  const Run run =
      testing::run(dir, {"-q", "--skip-invalid", "--normals", "--ascii", "a.ply", "b.ply"});
  CHECK(run.status == 0);
  CHECK(run.err == "tetsculpt: --normals replaces the normals of the input\n");
  CHECK(body(bytes_of(dir.path() / "b.ply"))
            .starts_with("0 0 0 2 20 200 -2 -0.57735026 -0.57735026 -0.57735026\n"));
}

}  // namespace
}  // namespace tetsculpt
