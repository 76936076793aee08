// The record of a sculpting: replayed, it gives the surface of every step; the last one is the
// mesh.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "kernel/sculpting_record.h"
#include "sculpt/boundary.h"
#include "sculpt/record.h"
#include "sculpt/sculpt_guided.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_replay.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Each with its smallest corner first, in order: equal for equal sets of oriented triangles.
Triangles canonical(Triangles triangles) {
  for (auto& t : triangles) std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  std::ranges::sort(triangles);
  return triangles;
}

Triangles boundary_of(const TetComplex& complex, const Flags& inside) {
  Triangles triangles;
  for (const auto& [a, b, c] : boundary_triangles(complex, inside)) {
    triangles.push_back({static_cast<std::uint32_t>(+a), static_cast<std::uint32_t>(+b),
                         static_cast<std::uint32_t>(+c)});
  }
  return triangles;
}

Sculpture guided(const testing::Stages& s) {
  return sculpt_guided(s.points(), s.complex, s.constraints.egh_triangles,
                       {.keep = GuidedOptions::Keep::kLabels});
}

/// At every step, the record's surface is the boundary of what is then inside.
void check_every_step(const testing::Stages& s, const SculptingSteps& steps,
                      const SculptingRecord& record) {
  Flags inside = Boundary(s.complex).solid();
  std::size_t next = 0;
  for (std::uint32_t step = 0; step <= record.step_count; ++step) {
    for (; next < steps.tets.size() && steps.step[next] == step; ++next) {
      inside[+steps.tets[next]] ^= 1;
    }
    REQUIRE(canonical(surface_after(record, step)) == canonical(boundary_of(s.complex, inside)));
  }
  CHECK(next == steps.tets.size());
}

TEST_CASE("by the paper: every step is the replayed solid's surface, closed and manifold") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const Sculpture sculpture = s.sculpt();
    const SculptingSteps steps = sculpting_steps(s.complex, sculpture);
    const SculptingRecord record = sculpting_record(s.complex, steps);
    REQUIRE_FALSE(broken_invariant(record, s.complex.vertex_count()));
    CHECK(record.step_count == testing::removal_steps(sculpture).size());
    check_every_step(s, steps, record);
    for (std::uint32_t step = 0; step <= record.step_count; ++step) {
      const auto points = s.points();
      const TriangleMesh mesh{{points.begin(), points.end()}, surface_after(record, step)};
      const auto broken = broken_invariant(mesh);
      INFO("step ", step, ": ", broken.value_or(""));
      REQUIRE_FALSE(broken);
    }
    CHECK(surface_after(record, record.step_count) == boundary_of(s.complex, sculpture.solid));
  }
}

TEST_CASE("guided: from the hull to the labels, then to the surface; nothing moves for nothing") {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  sets.push_back({"noise", point_sets::uniform_cube(300, 7)});
  std::size_t moved = 0;
  for (const testing::NamedSet& set : sets) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const Sculpture sculpture = guided(s);
    const SculptingSteps steps = sculpting_steps(s.complex, sculpture);
    const SculptingRecord record = sculpting_record(s.complex, steps);
    REQUIRE_FALSE(broken_invariant(record, s.complex.vertex_count()));
    check_every_step(s, steps, record);
    CHECK(surface_after(record, record.step_count) == boundary_of(s.complex, sculpture.solid));

    REQUIRE(sculpture.labels.size() == s.complex.tet_count());
    std::size_t outside = 0;
    for (const TetId t : s.tets()) {
      outside += sculpture.labels[+t] == 0;
      moved += sculpture.labels[+t] != sculpture.solid[+t];
    }
    const std::span<const TetId> first = std::span(steps.tets).first(outside);
    for (const TetId t : first) REQUIRE(sculpture.labels[+t] == 0);
    CHECK(std::set<TetId>(first.begin(), first.end()).size() == outside);
  }
  CHECK(moved > 0);
}

TEST_CASE("what the labels put outside goes from the hull inwards") {
  const testing::Stages s = testing::stages(point_sets::torus(0.25, 1));
  const SculptingSteps steps = sculpting_steps(s.complex, guided(s));
  Flags gone(s.complex.tet_count(), 0);
  std::fill(gone.begin() + static_cast<std::ptrdiff_t>(s.complex.finite_tet_count()), gone.end(),
            std::uint8_t{1});
  for (const TetId t : steps.tets) {
    const auto next_to_gone = [&](int i) { return gone[+s.complex.neighbor(t, i)] != 0; };
    REQUIRE((next_to_gone(0) || next_to_gone(1) || next_to_gone(2) || next_to_gone(3)));
    gone[+t] = 1;
  }
}

}  // namespace
}  // namespace tetsculpt
