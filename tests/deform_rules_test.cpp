// One flip at a time: the paper's basic rules, stated over on sets of corners, decide it.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "sculpt/boundary.h"
#include "sculpt/circumspheres.h"
#include "sculpt/deform.h"
#include "sculpt/star_inspector.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_replay.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::Corners;
using testing::EndPoints;

/// The triangles, edges and vertices between inside and outside, and of the infinite ones none.
struct Between {
  std::map<Corners, int> triangles;  ///< how many tetrahedra inside have it
  std::map<EndPoints, int> edges;
  std::map<VertexId, int> vertices;

  Between(const testing::Stages& s, const Flags& inside) {
    for (const TetId t : s.tets()) {
      if (!inside[+t]) continue;
      for (const Corners& c : testing::facets_of(s.complex.vertices(t))) ++triangles[c];
    }
    std::erase_if(triangles, [](const auto& entry) { return entry.second != 1; });
    for (const auto& [c, count] : triangles) {
      for (const EndPoints& e : testing::edges_of(c)) ++edges[e];
      for (const VertexId v : c) ++vertices[v];
    }
  }

  bool allows(const std::array<VertexId, 4>& tet) const {
    std::vector<Corners> exposed;
    for (const Corners& c : testing::facets_of(tet)) {
      if (triangles.contains(c)) exposed.push_back(c);
    }
    // The corners that are not in all exposed facets: with one the apex, with two the far edge.
    std::vector<VertexId> opposite;
    for (const VertexId v : tet) {
      const auto has = [v](const Corners& c) { return std::ranges::count(c, v) > 0; };
      if (!std::ranges::all_of(exposed, has)) opposite.push_back(v);
    }
    if (exposed.size() == 1) return !vertices.contains(opposite[0]);
    std::ranges::sort(opposite);
    return exposed.size() == 2 && !edges.contains({opposite[0], opposite[1]});
  }
};

/// Deforms towards labels that differ in one tetrahedron; true if that came about.
bool flips_alone(const testing::Stages& s, const Circumspheres& spheres, const Flags& inside,
                 TetId t) {
  Flags wanted = inside;
  wanted[+t] ^= 1;
  Boundary boundary(s.complex, inside);
  deform_towards(boundary, spheres, wanted, FlipOrder::kSmallestFirst);
  if (boundary.solid() == wanted) return true;
  REQUIRE(boundary.solid() == inside);
  return false;
}

TEST_CASE("each flip, on the way of a surface that moves at random") {
  int flipped = 0, refused = 0, added = 0;
  for (const testing::NamedSet& set : testing::small_sets()) {
    const testing::Stages s = testing::stages(set.points);
    const Circumspheres spheres(s.points(), s.complex);
    point_sets::Random random(1);
    const std::vector<TetId> tets = s.tets();
    Flags inside(s.complex.tet_count(), 0);
    for (const TetId t : tets) inside[+t] = 1;
    for (int step = 0; step < 150; ++step) {
      const TetId t = tets[random.below(tets.size())];
      INFO(set, ", steps of seed 1, step ", step);
      const bool allowed = Between(s, inside).allows(s.complex.vertices(t));
      REQUIRE(flips_alone(s, spheres, inside, t) == allowed);
      ++(allowed ? flipped : refused);
      if (!allowed) continue;
      inside[+t] ^= 1;
      added += inside[+t];
    }
  }
  CHECK(flipped > 500);
  CHECK(refused > 500);
  CHECK(added > 50);
}

TEST_CASE("nothing wanted, nothing done") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    Boundary boundary(s.complex);
    const Flags before = boundary.solid();
    deform_towards(boundary, Circumspheres(s.points(), s.complex), before,
                   FlipOrder::kLargestFirst);
    CHECK(boundary.solid() == before);
  }
}

}  // namespace
}  // namespace tetsculpt
