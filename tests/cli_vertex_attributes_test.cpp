// Which input point's attributes a vertex of the surface gets.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/support/sculpt_stages.h"
#include "tools/surface_file.h"

namespace tetsculpt {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// For each vertex the number of the input point whose attributes it has.
Numbers sources(const std::vector<Point3>& points, const Reconstruction& result,
                const std::vector<std::size_t>& index_in_file, std::size_t file_size) {
  Numbers numbers(file_size);
  for (std::uint32_t i = 0; i < file_size; ++i) numbers[i] = i;
  const std::vector<Attribute> of_file = {{"number", numbers}};
  const auto taken = cli::vertex_attributes(of_file, result, index_in_file);
  REQUIRE(taken.size() == 1);
  CHECK(taken[0].name == "number");
  const Numbers& of_vertices = std::get<Numbers>(taken[0].values);
  REQUIRE(of_vertices.size() == result.mesh.points.size());
  for (std::size_t v = 0; v < of_vertices.size(); ++v) {
    const auto it = std::ranges::find(index_in_file, of_vertices[v]);
    REQUIRE(it != index_in_file.end());
    CHECK(points[static_cast<std::size_t>(it - index_in_file.begin())] == result.mesh.points[v]);
  }
  return of_vertices;
}

std::vector<std::size_t> all(std::size_t count) {
  std::vector<std::size_t> index(count);
  for (std::size_t i = 0; i < count; ++i) index[i] = i;
  return index;
}

TEST_CASE("of equal points the first") {
  const std::vector<Point3> points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0},
                                      {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  const Reconstruction result = reconstruct(points);
  CHECK(sources(points, result, all(7), 7) == Numbers{0, 2, 4, 5});
}

TEST_CASE("points that were skipped count") {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  const Reconstruction result = reconstruct(points);
  CHECK(sources(points, result, {1, 2, 5, 6, 9}, 10) == Numbers{1, 2, 5, 9});
}

TEST_CASE("a hidden point has no vertex") {
  const auto points = testing::set_with_hidden_point();
  const Reconstruction result = reconstruct(points, {.method = Method::kPaper});
  REQUIRE(result.hidden.size() == 1);
  Numbers expected;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (i != result.hidden[0]) expected.push_back(i);
  }
  CHECK(sources(points, result, all(points.size()), points.size()) == expected);
}

}  // namespace
}  // namespace tetsculpt
