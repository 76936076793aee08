// The guided method's oriented triangles are one function of the set of points: not of their order,
// the number of threads, or the unit of length.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

using testing::oriented_triangles;

std::vector<testing::NamedSet> all_sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  sets.push_back({"box of 700, seed 1", point_sets::uniform_cube(700, 1)});
  sets.push_back({"lattice of side 8, seed 1", point_sets::random_lattice(400, 8, 1)});
  sets.push_back({"grid of side 6", point_sets::grid(6)});
  sets.push_back({"lattice sphere 194", point_sets::lattice_sphere(194)});
  sets.push_back({"clusters of 300, seed 1", point_sets::clusters(300, 1)});
  return sets;
}

TEST_CASE("shuffled input") {
  for (const testing::NamedSet& set : all_sets()) {
    const auto triangles = oriented_triangles(reconstruct(set.points).mesh);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      INFO(set, ", shuffled by seed ", seed);
      const auto shuffled = point_sets::shuffled(set.points, seed);
      CHECK((oriented_triangles(reconstruct(shuffled).mesh) == triangles));
    }
  }
}

TEST_CASE("points given twice change nothing") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    const Reconstruction once = reconstruct(set.points);
    const Reconstruction twice = reconstruct(point_sets::joined(set.points, set.points));
    CHECK(twice.mesh.points == once.mesh.points);
    CHECK(twice.mesh.triangles == once.mesh.triangles);
    CHECK(twice.hidden == once.hidden);
  }
}

TEST_CASE("two threads: the same mesh") {
  std::vector<testing::NamedSet> sets = all_sets();
  sets.push_back({"random torus of 3000, seed 4", point_sets::random_torus(3000, 4)});
  for (const testing::NamedSet& set : sets) {
    INFO(set);
    ReconstructOptions options;
    options.threads = 2;
    const Reconstruction one = reconstruct(set.points);
    const Reconstruction two = reconstruct(set.points, options);
    CHECK(two.mesh.points == one.mesh.points);
    CHECK(two.mesh.triangles == one.mesh.triangles);
    CHECK(two.hidden == one.hidden);
  }
}

TEST_CASE("scaling by a power of two changes nothing, however large or small") {
  for (const testing::NamedSet& set : all_sets()) {
    const auto triangles = oriented_triangles(reconstruct(set.points).mesh);
    for (const int exponent : {490, -460, 140, -100, 60, -1}) {
      INFO(set, ", times 2^", exponent);
      const double scale = std::ldexp(1.0, exponent);
      const Reconstruction scaled = reconstruct(point_sets::scaled(set.points, scale));
      CHECK((oriented_triangles(scaled.mesh, 1 / scale) == triangles));
    }
  }
}

}  // namespace
}  // namespace tetsculpt
