// Two starts, and the one that ends with the less energy wins: the labels of the cut before any
// pole insisted, whose topology is plain but which miss most of what is thin, and those after some
// insistence that are nearest to a surface. From either, stars that are not good are mended; the
// surface moves by the paper's basic rules to the labels on which all poles insisted, then to the
// vertices that are still hidden, by single flips and by walks of many; all this keeps its
// topology. A search that need not keep it comes last.
#include "sculpt/mend_surface.h"

#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "kernel/vertex_stars.h"
#include "sculpt/boundary.h"
#include "sculpt/deform.h"
#include "sculpt/energy.h"
#include "sculpt/flip_walk.h"
#include "sculpt/labels.h"
#include "sculpt/star_fill.h"
#include "sculpt/star_search.h"

namespace tetsculpt {
namespace {

/// Steps of walks that keep the topology, and flips of searches that need not, in this order until
/// one brings the vertex out.
constexpr std::size_t kWalks[] = {100, 2000, 20000};
constexpr std::size_t kMostSteps = 500'000;  ///< of all walks of one length
constexpr std::size_t kSearches[] = {256, 4096, 65536};
/// With more than one hidden vertex in so many, as in noise or on open sheets, labels are no
/// surface to start from: the convex hull is.
constexpr std::size_t kManyPerManyHidden = 8;
constexpr std::size_t kMendFlips = 200'000;

using Progress = std::function<void(double)>;

/// A part of the work as the whole sees it.
Progress part(const Progress& whole, double begin, double end) {
  return [&whole, begin, end](double done) { whole(begin + (end - begin) * done); };
}

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
void for_hidden(const Boundary& boundary, const Progress& progress, Expose&& expose) {
  const std::vector<VertexId> hidden = boundary.hidden_vertices();
  for (std::size_t k = 0; k < hidden.size(); ++k) {
    progress(static_cast<double>(k) / static_cast<double>(hidden.size()));
    if (!boundary.on_boundary(hidden[k])) expose(hidden[k]);
  }
}

void search_hidden(Boundary& boundary, const VertexStars& stars, const Evidence& evidence,
                   const Progress& progress) {
  constexpr double kPasses = std::size(kWalks) + std::size(kSearches);
  double pass = 0;
  const auto next_pass = [&] {
    const Progress mine = part(progress, pass / kPasses, (pass + 1) / kPasses);
    ++pass;
    return mine;
  };
  for (const std::size_t steps : kWalks) {
    if (steps * boundary.hidden_count() > kMostSteps) break;
    for_hidden(boundary, next_pass(),
               [&](VertexId v) { expose_by_walk(boundary, stars, v, steps); });
  }
  if (boundary.hidden_count() == 0) return;
  StarSearch search(boundary, stars, evidence);
  for (const std::size_t flips : kSearches) {
    for_hidden(boundary, next_pass(), [&](VertexId v) { search.expose(v, flips); });
  }
}

/// Moves a start to the labels on which the poles insisted, and through all vertices.
Boundary surface_from(Flags start, const Flags& wanted, const TetComplex& complex,
                      const VertexStars& stars, const Circumspheres& spheres,
                      const Evidence& evidence, const Progress& progress) {
  Boundary boundary(complex, std::move(start));
  progress(0.1);
  if (few_hidden(boundary.hidden_count(), complex.vertex_count())) {
    mend(boundary, stars, evidence);
    progress(0.2);
    deform_towards(boundary, spheres, wanted, FlipOrder::kSmallestFirst);
  } else {
    boundary = Boundary(complex);
    deform_towards(boundary, spheres, wanted, FlipOrder::kLargestFirst);
  }
  progress(0.4);
  Flags solid = boundary.solid();
  expose_hidden(complex, spheres, boundary.hidden_vertices(), solid);
  progress(0.5);
  boundary = Boundary(complex, std::move(solid));
  search_hidden(boundary, stars, evidence, part(progress, 0.6, 1));
  return boundary;
}

}  // namespace

Sculpture mended_surface(const TetComplex& complex, const Circumspheres& spheres,
                         const Evidence& evidence, const StarFaults& faults, Flags alone,
                         const Progress& progress) {
  const VertexStars stars(complex);
  RefinedLabels labels =
      refined_labels(complex, stars, std::move(alone), faults, evidence, part(progress, 0, 0.5));
  const auto quality = [&](const Boundary& boundary) {
    return std::pair(boundary.hidden_count(), energy(complex, evidence, boundary.solid()));
  };
  Boundary best = surface_from(std::move(labels.likely), labels.wanted, complex, stars, spheres,
                               evidence, part(progress, 0.5, 0.75));
  if (few_hidden(faults.hidden.size(), complex.vertex_count())) {
    Boundary plain = surface_from(std::move(labels.first), labels.wanted, complex, stars, spheres,
                                  evidence, part(progress, 0.75, 1));
    if (quality(plain) < quality(best)) best = std::move(plain);
  }
  return {.solid = best.solid(), .hidden = best.hidden_vertices()};
}

}  // namespace tetsculpt
