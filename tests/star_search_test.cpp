// The search over labels: where it succeeds all stars are good and no vertex has left the surface;
// where it fails nothing has changed; done twice it does the same.
#include "sculpt/star_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/evidence.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

constexpr double kShares[] = {0.01, 0.05, 0.2, 0.5, 0.8, 0.95};
constexpr std::size_t kEnough = 200'000;

/// A complex with any energy at all: of either sign, and in part without a difference.
struct Scene {
  Scene(const std::vector<Point3>& points, std::uint64_t seed)
      : s(testing::stages(points)), stars(s.complex) {
    point_sets::Random random(seed);
    const auto number = [&] {
      return random.below(3) == 0 ? 0.0f : static_cast<float>(random.uniform(-1, 1));
    };
    for (std::size_t t = 0; t < s.complex.finite_tet_count(); ++t) {
      evidence.inside_bias.push_back(number());
    }
    for (std::size_t t = 0; t < s.complex.triangle_count(); ++t) {
      evidence.overlap.push_back(number());
    }
    evidence.egh_triangles = s.constraints.egh_triangles;
    evidence.believed.resize(s.complex.vertex_count());
  }
  Scene(const Scene&) = delete;

  /// Of a boundary that was changed: its counts are right, and no vertex is hidden that was not.
  void check(const Boundary& boundary, const std::vector<VertexId>& hidden_before) const {
    const auto wrong = broken_invariant(boundary);
    REQUIRE_MESSAGE(!wrong, *wrong);
    REQUIRE(s.all_stars_good(stars, boundary.solid()));
    REQUIRE(std::ranges::includes(hidden_before, boundary.hidden_vertices()));
    for (std::size_t t = s.complex.finite_tet_count(); t < s.complex.tet_count(); ++t) {
      REQUIRE(boundary.solid()[t] == 0);
    }
  }

  testing::Stages s;
  VertexStars stars;
  Evidence evidence;
};

std::vector<testing::NamedSet> all_sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  return testing::some_of(std::move(sets));
}

TEST_CASE("mending random labels") {
  int mended = 0, failed = 0;
  for (const testing::NamedSet& set : all_sets()) {
    const Scene scene(set.points, 1);
    for (const double share : kShares) {
      INFO(set, ", labels of seed 2, share ", share, ", evidence of seed 1");
      const Flags labels = scene.s.random_labels(share, 2);
      Boundary boundary(scene.s.complex, labels);
      const auto hidden = boundary.hidden_vertices();
      StarSearch search(boundary, scene.stars, scene.evidence);
      for (const std::size_t flips : {std::size_t{0}, std::size_t{3}, kEnough}) {
        if (search.mend_bad(flips)) {
          scene.check(boundary, hidden);
          if (scene.s.all_stars_good(scene.stars, labels)) REQUIRE(boundary.solid() == labels);
          ++mended;
          break;
        }
        REQUIRE(boundary.solid() == labels);
        const auto wrong = broken_invariant(boundary);
        REQUIRE_MESSAGE(!wrong, *wrong);
        ++failed;
      }
    }
  }
  CHECK(mended > testing::random_cases(200));
  CHECK(failed > testing::random_cases(200));
}

/// Mends random labels, then brings out what is hidden one by one. Counts both outcomes.
Flags mend_and_expose(const Scene& scene, const Flags& labels, std::array<int, 2>& outcomes) {
  Boundary boundary(scene.s.complex, labels);
  StarSearch search(boundary, scene.stars, scene.evidence);
  if (!search.mend_bad(kEnough)) return labels;
  for (const std::size_t flips : {0u, 2u, 64u, 4096u}) {
    for (const VertexId v : testing::some_of(boundary.hidden_vertices())) {
      const auto hidden = boundary.hidden_vertices();
      if (!std::ranges::binary_search(hidden, v)) continue;  // came out with another one
      const Flags before = boundary.solid();
      INFO("vertex ", +v, ", at most ", flips, " flips");
      const bool out = search.expose(v, flips);
      ++outcomes[out];
      REQUIRE(boundary.on_boundary(v) == out);
      if (!out) REQUIRE(boundary.solid() == before);
      scene.check(boundary, hidden);
    }
  }
  return boundary.solid();
}

TEST_CASE("bringing out hidden vertices, and the same again") {
  std::array<int, 2> outcomes{};
  for (const testing::NamedSet& set : testing::some_of(testing::small_sets())) {
    const Scene scene(set.points, 3);
    for (const double share : kShares) {
      INFO(set, ", labels of seed 4, share ", share, ", evidence of seed 3");
      const Flags labels = scene.s.random_labels(share, 4);
      const Flags once = mend_and_expose(scene, labels, outcomes);
      REQUIRE(mend_and_expose(scene, labels, outcomes) == once);
    }
  }
  CHECK(outcomes[0] > testing::random_cases(500));
  CHECK(outcomes[1] > testing::random_cases(500));
}

}  // namespace
}  // namespace tetsculpt
