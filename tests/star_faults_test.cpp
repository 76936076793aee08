// Faults found from boundary triangles are those of the stars.
#include "sculpt/star_faults.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/star_inspector.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

/// How many faults of either kind were seen.
struct Seen {
  std::size_t hidden = 0;
  std::size_t bad = 0;
};

void check(const testing::Stages& s, const VertexStars& stars, const Flags& inside, Seen& seen) {
  StarInspector inspector(s.complex, stars);
  std::vector<VertexId> hidden, bad;
  for (std::uint32_t v = 0; v < s.complex.vertex_count(); ++v) {
    const StarParts parts = inspector.parts(VertexId{v}, inside);
    if (parts.one_sided()) hidden.push_back(VertexId{v});
    if (parts.excess() > 0) bad.push_back(VertexId{v});
  }
  const StarFaults faults =
      star_faults(s.complex.vertex_count(), boundary_triangles(s.complex, inside));
  REQUIRE((faults.hidden == hidden));
  REQUIRE((faults.bad == bad));
  seen.hidden += hidden.size();
  seen.bad += bad.size();
}

TEST_CASE("random labels, small stars and very large ones") {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  sets.push_back({"plane and apex, 400", point_sets::plane_and_apex(400, 1)});
  Seen seen;
  for (const testing::NamedSet& set : sets) {
    const testing::Stages s = testing::stages(set.points);
    const VertexStars stars(s.complex);
    std::uint64_t seed = 0;
    for (const double share : {0.0, 0.05, 0.3, 0.7, 0.95, 1.0}) {
      INFO(set, ", labels of seed ", ++seed);
      point_sets::Random random(seed);
      Flags inside(s.complex.tet_count(), 0);
      for (const TetId t : s.tets()) inside[+t] = random.uniform() < share;
      check(s, stars, inside, seen);
    }
  }
  MESSAGE(seen.hidden, " hidden and ", seen.bad, " bad vertices");
  CHECK(seen.hidden > 1000);
  CHECK(seen.bad > 1000);
}

}  // namespace
}  // namespace tetsculpt
