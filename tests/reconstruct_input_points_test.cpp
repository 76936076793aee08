// The surface's points are the input's: bit for bit, in input order, equal ones once.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "kernel/distinct_points.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"
#include "tests/support/sculpt_surface.h"

namespace tetsculpt {
namespace {

using testing::reconstruct_paper;

std::tuple<std::uint64_t, std::uint64_t, std::uint64_t> bits(const Point3& p) {
  return {std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
          std::bit_cast<std::uint64_t>(p.z)};
}

/// The points and the map from input to vertex, by what the header promises.
void check_points(const std::vector<Point3>& input, const Reconstruction& result) {
  std::map<std::tuple<double, double, double>, std::uint32_t> first;
  std::vector<std::size_t> hidden = result.hidden;
  std::uint32_t vertices = 0;
  REQUIRE(result.vertex_of_input.size() == input.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    const Point3& p = input[i];
    const bool is_hidden = std::ranges::find(hidden, i) != hidden.end();
    const auto [place, is_new] =
        first.try_emplace({p.x, p.y, p.z}, is_hidden ? Reconstruction::kHidden : vertices);
    REQUIRE(result.vertex_of_input[i] == place->second);
    if (!is_new || is_hidden) continue;
    REQUIRE(bits(result.mesh.points.at(vertices)) == bits(p));
    ++vertices;
  }
  REQUIRE(result.mesh.points.size() == vertices);
  REQUIRE(result.counts.vertices == first.size());
  REQUIRE(result.counts.vertices == vertices + hidden.size());
}

TEST_CASE("small sets, many with duplicates") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    check_points(set.points, reconstruct_paper(set.points));
    const auto doubled = point_sets::shuffled(point_sets::joined(set.points, set.points), 3);
    check_points(doubled, reconstruct_paper(doubled));
  }
}

TEST_CASE("a hidden point is reported by its first index and is no point of the surface") {
  std::vector<Point3> input = testing::set_with_hidden_point();
  const Reconstruction result = reconstruct_paper(input);
  REQUIRE(result.hidden.size() == 1);
  check_points(input, result);
  const Point3 hidden = input[result.hidden[0]];
  CHECK(std::ranges::count(result.mesh.points, hidden) == 0);
  CHECK_FALSE(broken_invariant(result.mesh));
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    INFO("twice, shuffled by seed ", seed);
    const auto twice = point_sets::shuffled(point_sets::joined(input, input), seed);
    const Reconstruction other = reconstruct_paper(twice);
    REQUIRE(other.hidden.size() == 1);
    CHECK(twice[other.hidden[0]] == hidden);
    check_points(twice, other);
  }
}

TEST_CASE("of equal points with differing zeros the first is written") {
  const std::vector<Point3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Point3> minus{{-0.0, 0, -0.0}, {1, -0.0, -0.0}, {-0.0, 1, 0}, {0, -0.0, 1}};
  for (const auto& input :
       {point_sets::joined(minus, corners), point_sets::joined(corners, minus), minus}) {
    const Reconstruction result = reconstruct_paper(input);
    check_points(input, result);
    CHECK(result.mesh.points.size() == 4);
    CHECK(std::signbit(result.mesh.points[0].x) == std::signbit(input[0].x));
  }
}

TEST_CASE("coordinates of any size and precision come back as they were") {
  std::vector<Point3> input = point_sets::uniform_cube(40, 5);
  for (Point3& p : input) p = {p.x + 5e6, p.y * 1e-3 - 7e5, p.z / 3};
  check_points(input, reconstruct_paper(input));
  input.push_back({1e9, -1e9, 1e-9});
  check_points(input, reconstruct_paper(input));
}

TEST_CASE("an invalid point is named by its index in the input") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
    for (const std::size_t place : {0u, 7u, 19u}) {
      for (double Point3::*const coordinate : {&Point3::x, &Point3::y, &Point3::z}) {
        std::vector<Point3> input = point_sets::uniform_cube(20, 6);
        input[place].*coordinate = bad;
        try {
          reconstruct_paper(input);
          FAIL("no exception");
        } catch (const InvalidPoint& error) {
          CHECK(error.index() == place);
          CHECK(std::string(error.what()).starts_with("point " + std::to_string(place) + ": "));
        }
      }
    }
  }
}

}  // namespace
}  // namespace tetsculpt
