// The set of oriented triangles is one function of the set of points: not of their order, the
// number of threads, or the unit of length.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

using testing::oriented_triangles;
using testing::reconstruct_paper;

std::vector<testing::NamedSet> sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  return sets;
}

TEST_CASE("shuffled input, every criterion") {
  for (const testing::NamedSet& set : sets()) {
    for (const Criterion criterion : testing::kAllCriteria) {
      const auto triangles = oriented_triangles(reconstruct_paper(set.points, criterion).mesh);
      for (const std::uint64_t seed : {1u, 2u}) {
        INFO(set, ", criterion ", static_cast<int>(criterion), ", shuffled by seed ", seed);
        const auto shuffled = point_sets::shuffled(set.points, seed);
        CHECK(oriented_triangles(reconstruct_paper(shuffled, criterion).mesh) == triangles);
      }
    }
  }
}

TEST_CASE("points given twice change nothing") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    const auto twice = point_sets::joined(set.points, set.points);
    const Reconstruction once = reconstruct_paper(set.points);
    const Reconstruction result = reconstruct_paper(twice);
    CHECK(result.mesh.points == once.mesh.points);
    CHECK(result.mesh.triangles == once.mesh.triangles);
  }
}

TEST_CASE("any number of threads: the same mesh") {
  for (const testing::NamedSet& set :
       {testing::NamedSet{"random torus, seed 4", point_sets::random_torus(3000, 4)},
        testing::NamedSet{"box, seed 5", point_sets::uniform_cube(2000, 5)},
        testing::NamedSet{"grid of side 9", point_sets::grid(9)}}) {
    const Reconstruction one = reconstruct_paper(set.points, Criterion::kConstrained, 1);
    for (const int threads : {2, 7}) {
      INFO(set, ", threads ", threads);
      const Reconstruction more = reconstruct_paper(set.points, Criterion::kConstrained, threads);
      CHECK(more.mesh.points == one.mesh.points);
      CHECK(more.mesh.triangles == one.mesh.triangles);
      CHECK(more.hidden == one.hidden);
      CHECK(more.counts.gabriel_edges == one.counts.gabriel_edges);
      CHECK(more.counts.egh_triangles == one.counts.egh_triangles);
    }
  }
}

TEST_CASE("scaling by a power of two changes nothing, however large or small") {
  for (const testing::NamedSet& set : sets()) {
    const auto triangles = oriented_triangles(reconstruct_paper(set.points).mesh);
    for (const int exponent : {490, -460, 60, -1}) {
      INFO(set, ", times 2^", exponent);
      const double scale = std::ldexp(1.0, exponent);
      const Reconstruction scaled = reconstruct_paper(point_sets::scaled(set.points, scale));
      CHECK(oriented_triangles(scaled.mesh, 1 / scale) == triangles);
    }
  }
}

}  // namespace
}  // namespace tetsculpt
