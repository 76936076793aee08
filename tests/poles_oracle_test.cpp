// Poles against their definition, over all tetrahedra.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernel/large_array.h"
#include "sculpt/circumspheres.h"
#include "sculpt/poles.h"
#include "tests/support/point_sets.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

using Vec = Vec3<double>;

/// The complex, its spheres and its poles.
struct Scene {
  explicit Scene(const std::vector<Point3>& points)
      : s(testing::stages(points)),
        spheres(s.points(), s.complex),
        pairs(poles(s.points(), s.complex, spheres)) {}

  /// From the vertex to the circumcentre.
  Vec to_centre(VertexId v, TetId t) const {
    return from_to(as_vector(s.points()[+v]), spheres.centre(t));
  }

  testing::Stages s;
  Circumspheres spheres;
  LargeArray<PolePair> pairs;
};

/// Calls visit with every tetrahedron at v.
template <class Visit>
void for_star(const TetComplex& complex, VertexId v, Visit&& visit) {
  for (std::uint32_t t = 0; t < complex.tet_count(); ++t) {
    if (std::ranges::count(complex.vertices(TetId{t}), v) > 0) visit(TetId{t});
  }
}

void check_first(const Scene& scene, VertexId v) {
  const PolePair& pair = scene.pairs[+v];
  REQUIRE(std::ranges::count(scene.s.complex.vertices(pair.first), v) == 1);
  REQUIRE(length(pair.axis) == doctest::Approx(1));
  Vec outward{0, 0, 0};
  bool on_hull = false;
  double largest = 0;
  for_star(scene.s.complex, v, [&](TetId t) {
    if (!scene.s.complex.finite(t)) {
      on_hull = true;
      outward = outward + scene.spheres.outward(t);
    } else if (std::isfinite(scene.spheres.radius(t))) {
      largest = std::max(largest, scene.spheres.radius(t));
    }
  });
  REQUIRE(scene.s.complex.finite(pair.first) == !on_hull);
  if (!on_hull) REQUIRE(scene.spheres.radius(pair.first) == largest);
  const Vec along = on_hull ? outward : scene.to_centre(v, pair.first);
  REQUIRE(dot(along, pair.axis) == doctest::Approx(length(along)));
}

void check_second(const Scene& scene, VertexId v) {
  const PolePair& pair = scene.pairs[+v];
  double largest = 0;
  for_star(scene.s.complex, v, [&](TetId t) {
    if (!scene.s.complex.finite(t) || std::isinf(scene.spheres.radius(t))) return;
    if (dot(scene.to_centre(v, t), pair.axis) < 0) {
      largest = std::max(largest, scene.spheres.radius(t));
    }
  });
  REQUIRE(pair.strength >= 0);
  REQUIRE(pair.strength <= 1);
  REQUIRE((pair.strength > 0) == (largest > 0));
  if (largest == 0) return;
  REQUIRE(std::ranges::count(scene.s.complex.vertices(pair.second), v) == 1);
  REQUIRE(scene.spheres.radius(pair.second) == largest);
  const Vec to = scene.to_centre(v, pair.second);
  // In flat tetrahedra the centre is not as far from all corners, by rounding.
  const double cosine = std::min(-dot(to, pair.axis) / largest, 1.0);
  REQUIRE(pair.strength == doctest::Approx(cosine));
}

TEST_CASE("the farthest centre, and the farthest opposite to it") {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  for (const testing::NamedSet& set : sets) {
    const Scene scene(set.points);
    REQUIRE(scene.pairs.size() == scene.s.complex.vertex_count());
    for (std::uint32_t v = 0; v < scene.pairs.size(); ++v) {
      INFO(set, ", vertex ", v);
      check_first(scene, VertexId{v});
      check_second(scene, VertexId{v});
    }
  }
}

}  // namespace
}  // namespace tetsculpt
