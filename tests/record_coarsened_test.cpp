// A coarsened record: fewer triangles, and only surfaces that the full one shows.
#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "kernel/sculpting_record.h"
#include "sculpt/record.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

constexpr std::uint32_t kNever = SculptingRecord::kNever;

SculptingRecord recorded(const std::vector<Point3>& points) {
  const testing::Stages s = testing::stages(points);
  return sculpting_record(s.complex, sculpting_steps(s.complex, s.sculpt()));
}

TEST_CASE(
    "each step is one of the record's; the first and the last are the same; as few as asked") {
  const SculptingRecord record = recorded(point_sets::torus(0.2, 1));
  const std::size_t least = coarsened(record, 0).triangles.size();
  REQUIRE(least < record.triangles.size() / 2);
  for (std::size_t most : {least, least + 50, least + 150, record.triangles.size() - 1}) {
    const SculptingRecord few = coarsened(record, most);
    REQUIRE_FALSE(broken_invariant(few, std::numeric_limits<std::uint32_t>::max()));
    CHECK(few.triangles.size() <= most);
    CHECK(few.step_count < record.step_count);
    CHECK(surface_after(few, 0) == surface_after(record, 0));
    CHECK(surface_after(few, few.step_count) == surface_after(record, record.step_count));
    std::uint32_t joined = 1;
    while ((record.step_count + joined - 1) / joined > few.step_count) joined *= 2;
    for (std::uint32_t step = 0; step < few.step_count; ++step) {
      REQUIRE(surface_after(few, step) == surface_after(record, step * joined));
    }
  }
}

TEST_CASE("what fits stays as it is") {
  const SculptingRecord record = recorded(point_sets::torus(0.3, 1));
  const SculptingRecord same = coarsened(record, record.triangles.size());
  CHECK(same.triangles == record.triangles);
  CHECK(same.born == record.born);
  CHECK(same.died == record.died);
  CHECK(same.step_count == record.step_count);
  CHECK(coarsened(SculptingRecord(), 0).step_count == 0);
}

TEST_CASE("the checker names what is wrong") {
  const SculptingRecord good{{{0, 1, 2}, {2, 1, 0}}, {0, 1}, {1, kNever}, 1};
  REQUIRE_FALSE(broken_invariant(good, 3));
  const auto fault = [&](auto&& spoil) {
    SculptingRecord bad = good;
    spoil(bad);
    return broken_invariant(bad, 3).value_or("none");
  };
  CHECK(fault([](auto& r) { r.born.pop_back(); }) == "the arrays differ in size");
  CHECK(fault([](auto& r) { r.died.push_back(1); }) == "the arrays differ in size");
  CHECK(fault([](auto& r) { r.triangles[1][2] = 3; }) ==
        "triangle 1 has a corner that is no vertex");
  CHECK(fault([](auto& r) { r.died[0] = 0; }) == "triangle 0 is never there");
  CHECK(fault([](auto& r) { r.born[1] = 2; }) == "triangle 1 comes after the last step");
  CHECK(fault([](auto& r) { r.died[0] = 2; }) == "triangle 0 goes after the last step");
}

}  // namespace
}  // namespace tetsculpt
