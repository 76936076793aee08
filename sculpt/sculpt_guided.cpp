// Guided sculpting. Tetrahedra whose circumspheres overlap deeply are labelled together
// (sculpt/label_graph); labels spread from infinity as a first guess (sculpt/first_guess), which
// tells each vertex's poles apart; all evidence (sculpt/evidence) is then weighed by a minimum cut
// (sculpt/labels). On well-sampled surfaces the boundary of its labels is a 2-manifold through all
// vertices as it stands. Elsewhere the few stars that are not good are mended (sculpt/star_search),
// and vertices that the cut left on one side, in thin or coarsely sampled places, insist in further
// cuts; the surface moves to them by the paper's basic rules, so that such a vertex pulls the
// surface to itself and can't tear a false handle into it (sculpt/deform). Only where these rules
// are stuck a search flips other tetrahedra, too. Figures of this and of other ways are in
// bench/RESULTS.md.
#include "sculpt/sculpt_guided.h"

#include <algorithm>
#include <utility>

#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/circumspheres.h"
#include "sculpt/deform.h"
#include "sculpt/energy.h"
#include "sculpt/evidence.h"
#include "sculpt/first_guess.h"
#include "sculpt/flip_walk.h"
#include "sculpt/label_graph.h"
#include "sculpt/labels.h"
#include "sculpt/poles.h"
#include "sculpt/star_fill.h"
#include "sculpt/star_search.h"

namespace tetsculpt {

namespace {

/// Steps of walks that keep the topology, and flips of searches that need not, in this order until
/// one brings the vertex out.
constexpr std::size_t kWalks[] = {100, 2000, 20000};
constexpr std::size_t kMostSteps = 500'000;  ///< of all walks of one length
constexpr std::size_t kSearches[] = {256, 4096, 65536};
/// Up to one hidden vertex in so many is brought out without new labels, if single flips do it.
constexpr std::size_t kManyPerFewHidden = 1024;
/// With more than one hidden vertex in so many, as in noise or on open sheets, labels are no
/// surface to start from: the convex hull is.
constexpr std::size_t kManyPerManyHidden = 8;
constexpr std::size_t kMendFlips = 200'000;

/// Makes all stars good.
void mend(Boundary& boundary, const VertexStars& stars, const Evidence& evidence) {
  if (StarSearch(boundary, stars, evidence).mend_bad(kMendFlips)) return;
  Flags filled = boundary.solid();
  fill_bad_stars(boundary.complex(), stars, filled);
  boundary = Boundary(boundary.complex(), std::move(filled));
}

bool few_hidden(std::size_t hidden, std::size_t vertices) {
  return hidden <= vertices / kManyPerManyHidden;
}

/// Calls expose with each vertex that is still hidden.
template <class Expose>
void for_hidden(const Boundary& boundary, Expose&& expose) {
  for (const VertexId v : boundary.hidden_vertices()) {
    if (!boundary.on_boundary(v)) expose(v);
  }
}

void search_hidden(Boundary& boundary, const VertexStars& stars, const Evidence& evidence) {
  for (const std::size_t steps : kWalks) {
    if (steps * boundary.hidden_count() > kMostSteps) break;
    for_hidden(boundary, [&](VertexId v) { expose_by_walk(boundary, stars, v, steps); });
  }
  if (boundary.hidden_count() == 0) return;
  StarSearch search(boundary, stars, evidence);
  for (const std::size_t flips : kSearches) {
    for_hidden(boundary, [&](VertexId v) { search.expose(v, flips); });
  }
}

}  // namespace

Sculpture sculpt_guided(std::span<const Point3> points, const TetComplex& complex,
                        const Flags& egh_triangles, const GuidedOptions& options) {
  const auto progress = [&](double done) {
    if (options.progress) options.progress(done);
  };
  const Circumspheres spheres(points, complex);
  const LargeArray<PolePair> pairs = poles(points, complex, spheres);
  LargeArray<float> overlap = overlaps(complex, spheres);
  progress(0.3);
  LabelGraph graph = label_graph(complex, overlap, Flags(complex.tet_count(), 0));
  Flags alone = contradicted_tets(complex, graph, pairs);
  if (std::find(alone.begin(), alone.end(), 1) != alone.end()) {
    graph = label_graph(complex, overlap, alone);
  }
  const LargeArray<Side> guess = first_guess(graph, overlap, pairs);
  progress(0.5);
  Evidence evidence =
      weigh_evidence(points, complex, spheres, pairs, graph, guess, overlap, egh_triangles);
  progress(0.7);
  CutLabels cut = cut_labels(complex, graph, evidence);
  progress(0.9);
  if (cut.faults.hidden.empty() && cut.faults.bad.empty()) return {.solid = std::move(cut.inside)};

  if (cut.faults.bad.empty() && cut.faults.hidden.size() <= points.size() / kManyPerFewHidden &&
      expose_hidden(complex, spheres, cut.faults.hidden, cut.inside).empty()) {
    return {.solid = std::move(cut.inside)};
  }
  const VertexStars stars(complex);
  RefinedLabels labels = refined_labels(complex, stars, std::move(alone), cut.faults, evidence);
  const auto surface_from = [&](Flags start) {
    Boundary boundary(complex, std::move(start));
    if (few_hidden(boundary.hidden_count(), points.size())) {
      mend(boundary, stars, evidence);
      deform_towards(boundary, spheres, labels.wanted, FlipOrder::kSmallestFirst);
    } else {
      boundary = Boundary(complex);
      deform_towards(boundary, spheres, labels.wanted, FlipOrder::kLargestFirst);
    }
    Flags solid = boundary.solid();
    expose_hidden(complex, spheres, boundary.hidden_vertices(), solid);
    boundary = Boundary(complex, std::move(solid));
    search_hidden(boundary, stars, evidence);
    return boundary;
  };
  const auto quality = [&](const Boundary& boundary) {
    return std::pair(boundary.hidden_count(), energy(complex, evidence, boundary.solid()));
  };
  Boundary best = surface_from(std::move(labels.likely));
  if (few_hidden(cut.faults.hidden.size(), points.size())) {
    Boundary plain = surface_from(std::move(labels.first));
    if (quality(plain) < quality(best)) best = std::move(plain);
  }
  return {.solid = best.solid(), .hidden = best.hidden_vertices()};
}

}  // namespace tetsculpt
