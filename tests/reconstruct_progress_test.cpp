// The progress callback: known stages in their order, shares from 0 to 1, and no effect on the
// result.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

struct Call {
  std::string stage;
  double done;
};

std::vector<Call> calls_for(const std::vector<Point3>& points, Reconstruction& result) {
  std::vector<Call> calls;
  ReconstructOptions options;
  options.method = Method::kPaper;
  options.progress = [&](std::string_view stage, double done) {
    calls.push_back({std::string(stage), done});
  };
  result = reconstruct(points, options);
  return calls;
}

TEST_CASE("each stage is named, in the order of the work") {
  for (const std::size_t n : {10u, 2000u, 30000u}) {
    INFO("box of ", n, ", seed 1");
    const auto points = point_sets::uniform_cube(n, 1);
    Reconstruction result;
    const std::vector<Call> calls = calls_for(points, result);
    std::vector<std::string> stages;
    for (const Call& call : calls) {
      CHECK(call.done >= 0);
      CHECK(call.done <= 1);
      const bool first = stages.empty() || stages.back() != call.stage;
      if (first) {
        CHECK(call.done == 0);
        stages.push_back(call.stage);
      }
    }
    CHECK(stages == std::vector<std::string>{"delaunay", "graphs", "sculpt"});
    if (n >= 30000) CHECK(calls.size() > 3);
    CHECK(result.mesh.triangles == testing::reconstruct_paper(points).mesh.triangles);
  }
}

TEST_CASE("no solid: nothing after the triangulation") {
  Reconstruction result;
  for (const Call& call : calls_for({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, result)) {
    CHECK(call.stage == "delaunay");
  }
  CHECK(result.span == Span::kPlane);
}

TEST_CASE("an exception of the callback passes through") {
  ReconstructOptions options;
  options.method = Method::kPaper;
  options.progress = [](std::string_view, double) { throw std::string("stop"); };
  CHECK_THROWS_AS(reconstruct(point_sets::uniform_cube(50, 1), options), std::string);
}

}  // namespace
}  // namespace tetsculpt
