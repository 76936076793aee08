// After every step of the paper's sculpting the boundary is a 2-manifold with
// v - e + f = 2 (s - h): checked on a structure of the test's own.
#include <doctest/doctest.h>

#include <vector>

#include "tests/support/sculpt_replay.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using testing::Replay;

/// Replays what was removed and checks the relation after every step.
void check_every_step(const testing::Stages& s, const Sculpture& sculpture) {
  Replay replay(s.complex);
  REQUIRE_FALSE(replay.not_manifold());
  REQUIRE(replay.euler_number() == 2);
  long holes = 0;
  for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
    for (const TetId t : step.tets) replay.remove(t);
    holes += step.hole;
    for (const TetId t : step.tets) {
      const auto wrong = replay.not_manifold_at(s.complex.vertices(t));
      REQUIRE_MESSAGE(!wrong, *wrong);
    }
    const long shells = static_cast<long>(replay.components());
    REQUIRE(shells == 1);
    REQUIRE(replay.euler_number() == 2 * (shells - holes));
  }
  CHECK_FALSE(replay.not_manifold());
  CHECK(replay.hidden_count() == sculpture.hidden.size());
}

void check_all_criteria(const std::vector<testing::NamedSet>& sets) {
  for (const testing::NamedSet& set : sets) {
    const testing::Stages s = testing::stages(set.points);
    for (const Criterion criterion : testing::kAllCriteria) {
      INFO(set, ", criterion ", static_cast<int>(criterion));
      const Sculpture sculpture = s.sculpt(criterion);
      if (criterion != Criterion::kConstrained) CHECK(sculpture.holes.empty());
      check_every_step(s, sculpture);
    }
  }
}

TEST_CASE("small sets, every criterion") { check_all_criteria(testing::small_sets()); }

TEST_CASE("sampled bodies, every criterion") { check_all_criteria(testing::bodies()); }

TEST_CASE("the paper's own stop") {
  for (const testing::NamedSet& set : testing::bodies()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    const Sculpture sculpture = s.sculpt(Criterion::kConstrained, PaperOptions::Stop::kAllExposed);
    CHECK(sculpture.hidden.empty());
    check_every_step(s, sculpture);
  }
}

// The local check above looks only at the vertices of what was removed.
TEST_CASE("small sets, the whole boundary after every step") {
  for (const testing::NamedSet& set : testing::small_sets()) {
    INFO(set);
    const testing::Stages s = testing::stages(set.points);
    Replay replay(s.complex);
    const Sculpture sculpture = s.sculpt();
    for (const testing::RemovalStep& step : testing::removal_steps(sculpture)) {
      for (const TetId t : step.tets) replay.remove(t);
      const auto wrong = replay.not_manifold();
      REQUIRE_MESSAGE(!wrong, *wrong);
    }
  }
}

TEST_CASE("the sets open holes, so that the relation is put to the test") {
  std::size_t holes = 0;
  for (const testing::NamedSet& set : testing::bodies()) {
    holes += testing::stages(set.points).sculpt().holes.size();
  }
  CHECK(holes >= 5);
}

}  // namespace
}  // namespace tetsculpt
