// broken_invariant of distinct points sees each kind of planted fault.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/distinct_points.h"
#include "tests/support/point_sets.h"

namespace tetsculpt {
namespace {

// Vertices: (0,0,0), (0,1,0), (2,0,0).
const std::vector<Point3> kInput{{2, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {2, 0, 0}};

bool detected(const std::function<void(DistinctPoints&)>& plant) {
  DistinctPoints distinct = distinct_points(kInput);
  REQUIRE_FALSE(broken_invariant(distinct, kInput));
  plant(distinct);
  return broken_invariant(distinct, kInput).has_value();
}

TEST_CASE("sound results pass") {
  const auto cube = point_sets::uniform_cube(300, 1);
  const auto lattice = point_sets::random_lattice(300, 4, 2);
  for (const auto& input :
       {cube, lattice, point_sets::scaled(cube, 1e200), point_sets::scaled(lattice, 1e-200)}) {
    const DistinctPoints distinct = distinct_points(input);
    CHECK(broken_invariant(distinct, input).value_or("sound") == "sound");
  }
}

TEST_CASE("faults in the points") {
  CHECK(detected([](DistinctPoints& d) { d.points[1].y = std::nextafter(1, 2); }));
  CHECK(detected([](DistinctPoints& d) { std::swap(d.points[0], d.points[1]); }));
  CHECK(detected([](DistinctPoints& d) { d.points[1] = d.points[0]; }));
  CHECK(detected([](DistinctPoints& d) { d.points.pop_back(); }));
  CHECK(detected([](DistinctPoints& d) { d.scale_exponent = 1; }));
}

TEST_CASE("a vertex that is no input point") {
  CHECK(detected([](DistinctPoints& d) {
    d.points.push_back({3, 0, 0});
    d.first_input.push_back(0);
  }));
}

TEST_CASE("faults in the map from input to vertex") {
  CHECK(detected([](DistinctPoints& d) { d.vertex_of_input.pop_back(); }));
  CHECK(detected([](DistinctPoints& d) { d.vertex_of_input[4] = VertexId{0}; }));
  CHECK(detected([](DistinctPoints& d) { d.vertex_of_input[4] = VertexId{3}; }));
  CHECK(detected([](DistinctPoints& d) { d.vertex_of_input[4] = kInfinite; }));
}

TEST_CASE("faults in the map from vertex to input") {
  CHECK(detected([](DistinctPoints& d) { d.first_input.pop_back(); }));
  CHECK(detected([](DistinctPoints& d) { d.first_input[0] = 5; }));
  CHECK(detected([](DistinctPoints& d) { d.first_input[1] = 3; }));  // a later duplicate
  CHECK(detected([](DistinctPoints& d) { d.first_input[2] = 4; }));
  CHECK(detected([](DistinctPoints& d) { d.first_input[1] = 0; }));  // another point
}

TEST_CASE("the checker reads the input, not only the result") {
  const DistinctPoints distinct = distinct_points(kInput);
  std::vector<Point3> other = kInput;
  other[3].z = 1;
  CHECK(broken_invariant(distinct, other));
  other.pop_back();
  CHECK(broken_invariant(distinct, other));
}

}  // namespace
}  // namespace tetsculpt
