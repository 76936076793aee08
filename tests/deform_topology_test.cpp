// Moving a surface keeps it a 2-manifold of the same topology, and no vertex leaves it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "kernel/triangle_mesh.h"
#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/circumspheres.h"
#include "sculpt/deform.h"
#include "sculpt/evidence.h"
#include "sculpt/first_guess.h"
#include "sculpt/label_graph.h"
#include "sculpt/labels.h"
#include "sculpt/poles.h"
#include "sculpt/star_fill.h"
#include "sculpt/star_search.h"
#include "tests/support/point_sets.h"
#include "tests/support/random_cases.h"
#include "tests/support/sculpt_stages.h"

namespace tetsculpt {
namespace {

std::vector<testing::NamedSet> all_sets() {
  std::vector<testing::NamedSet> sets = testing::small_sets();
  for (testing::NamedSet& set : testing::bodies()) sets.push_back(std::move(set));
  sets.push_back({"box of 500, seed 1", point_sets::uniform_cube(500, 1)});
  sets.push_back({"lattice sphere 101", point_sets::lattice_sphere(101)});
  return testing::some_of(std::move(sets));
}

/// The complex with what deforming needs, and what the evidence says.
struct Scene {
  explicit Scene(const std::vector<Point3>& points)
      : s(testing::stages(points)), stars(s.complex), spheres(s.points(), s.complex) {
    const LargeArray<PolePair> pairs = poles(s.points(), s.complex, spheres);
    LargeArray<float> overlap = overlaps(s.complex, spheres);
    const Flags alone(s.complex.tet_count(), 0);
    const LabelGraph graph = label_graph(s.complex, overlap, alone);
    const LargeArray<Side> guess = first_guess(graph, pairs);
    evidence = weigh_evidence(s.points(), s.complex, spheres, pairs, graph, guess,
                              std::move(overlap), s.constraints.egh_triangles);
    const StarFaults faults = cut_labels(s.complex, graph, evidence).faults;
    labels = refined_labels(s.complex, stars, alone, faults, evidence);
  }

  /// The same labels or others, with good stars only.
  Flags mended(const Flags& inside) const {
    Boundary boundary(s.complex, inside);
    if (StarSearch(boundary, stars, evidence).mend_bad(100000)) return boundary.solid();
    Flags filled = inside;
    fill_bad_stars(s.complex, stars, filled);
    return filled;
  }
  /// The whole hull, good labels from the evidence, and random ones made good.
  std::vector<Flags> good_labels() const {
    return {Boundary(s.complex).solid(), mended(labels.likely), mended(s.random_labels(0.1, 1)),
            mended(s.random_labels(0.4, 1))};
  }

  testing::Stages s;
  VertexStars stars;
  Circumspheres spheres;
  Evidence evidence;
  RefinedLabels labels;
};

/// What a surface was, and that it still is that.
class Kept {
 public:
  Kept(const Scene& scene, const Boundary& boundary)
      : scene_(scene),
        before_(topology(scene.s.surface(boundary.solid()))),
        hidden_(boundary.hidden_vertices()) {
    REQUIRE((before_.edge_manifold && before_.vertex_manifold && before_.oriented));
  }

  void check(const Boundary& boundary) const {
    const auto wrong = broken_invariant(boundary);
    REQUIRE_MESSAGE(!wrong, *wrong);
    const Topology after = topology(scene_.s.surface(boundary.solid()));
    REQUIRE((after.edge_manifold && after.vertex_manifold && after.oriented));
    REQUIRE(after.closed == before_.closed);  // without a solid there is nothing that is closed
    REQUIRE(after.components == before_.components);
    REQUIRE(after.genus == before_.genus);
    const std::vector<VertexId> hidden = boundary.hidden_vertices();
    REQUIRE(hidden.size() == boundary.hidden_count());
    REQUIRE(std::ranges::includes(hidden_, hidden));  // no vertex has left
  }

 private:
  const Scene& scene_;
  Topology before_;
  std::vector<VertexId> hidden_;
};

TEST_CASE("towards random labels, each tetrahedron once at most") {
  for (const testing::NamedSet& set : all_sets()) {
    const Scene scene(set.points);
    for (const Flags& labels : scene.good_labels()) {
      for (const double share : {0.0, 0.5, 1.0}) {
        INFO(set, ", labels of seed 1, wanted share ", share, ", seed 2");
        const Flags wanted = scene.s.random_labels(share, 2);
        Boundary boundary(scene.s.complex, labels);
        const Kept kept(scene, boundary);
        deform_towards(boundary, scene.spheres, wanted,
                       share < 0.5 ? FlipOrder::kLargestFirst : FlipOrder::kSmallestFirst);
        kept.check(boundary);
        for (std::size_t t = 0; t < labels.size(); ++t) {
          REQUIRE((boundary.solid()[t] == labels[t] || boundary.solid()[t] == wanted[t]));
        }
      }
    }
  }
}

TEST_CASE("towards the labels that the evidence wants, and to hidden vertices") {
  for (const testing::NamedSet& set : all_sets()) {
    const Scene scene(set.points);
    FlipOrder order = FlipOrder::kLargestFirst;  // for the hull, which comes first
    for (const Flags& labels : scene.good_labels()) {
      INFO(set, ", labels of seed 1");
      Boundary boundary(scene.s.complex, labels);
      const Kept kept(scene, boundary);
      deform_towards(boundary, scene.spheres, scene.labels.wanted,
                     std::exchange(order, FlipOrder::kSmallestFirst));
      kept.check(boundary);
      Flags solid = boundary.solid();
      const auto left =
          expose_hidden(scene.s.complex, scene.spheres, boundary.hidden_vertices(), solid);
      boundary = Boundary(scene.s.complex, solid);
      kept.check(boundary);
      REQUIRE(boundary.hidden_vertices() == left);
    }
  }
}

}  // namespace
}  // namespace tetsculpt
