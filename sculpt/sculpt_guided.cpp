// Guided sculpting. Evidence (sculpt/evidence) is turned into labels by a minimum cut
// (sculpt/labels). On well-sampled surfaces the boundary of these labels is nearly a 2-manifold
// through nearly all vertices as it stands. The few stars that are not good are mended
// (sculpt/star_repair). Vertices that the cut left on one side, in thin or coarsely sampled places,
// insist in further cuts; the surface moves to them by the paper's basic rules only, so that such a
// vertex pulls the surface to itself and can't tear a false handle into it (sculpt/deform). Figures
// of this and of other ways are in bench/RESULTS.md.
#include "sculpt/sculpt_guided.h"

#include <utility>

#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/circumspheres.h"
#include "sculpt/deform.h"
#include "sculpt/evidence.h"
#include "sculpt/labels.h"
#include "sculpt/star_repair.h"

namespace tetsculpt {

namespace {

/// Moves a surface to the wanted labels and through the vertices it does not reach yet.
Boundary moved(Boundary boundary, const Flags& wanted, FlipOrder order, const VertexStars& stars,
               const Circumspheres& spheres) {
  deform_towards(boundary, spheres, wanted, order);
  expose_hidden(boundary, stars, spheres);
  return boundary;
}

}  // namespace

Sculpture sculpt_guided(std::span<const Point3> points, const TetComplex& complex,
                        const Flags& egh_triangles, const GuidedOptions& options) {
  const auto progress = [&](double done) {
    if (options.progress) options.progress(done);
  };
  const VertexStars stars(complex);
  const Circumspheres spheres(points, complex);
  Evidence evidence = weigh_evidence(points, complex, stars, spheres, egh_triangles);
  progress(0.4);
  Labels labels = cut_labels(complex, stars, evidence);
  progress(0.7);
  repair_stars(complex, stars, evidence, labels.likely);
  progress(0.8);
  Boundary boundary = moved(Boundary(complex, std::move(labels.likely)), labels.wanted,
                            FlipOrder::kSmallestFirst, stars, spheres);
  const auto try_from = [&](Boundary start) {
    if (boundary.hidden_count() == 0) return;
    start = moved(std::move(start), labels.wanted, FlipOrder::kLargestFirst, stars, spheres);
    if (start.hidden_count() < boundary.hidden_count()) boundary = std::move(start);
  };
  if (boundary.hidden_count() > 0) {
    const Boundary hull(complex);
    Boundary filled = boundary;
    deform_towards(filled, spheres, hull.solid(), FlipOrder::kSmallestFirst);
    try_from(std::move(filled));
    try_from(hull);
  }
  return {.solid = boundary.solid(), .hidden = boundary.hidden_vertices()};
}

}  // namespace tetsculpt
