// Guided sculpting. Tetrahedra whose circumspheres overlap deeply are labelled together
// (sculpt/label_graph); labels spread from infinity as a first guess (sculpt/first_guess), which
// tells each vertex's poles apart; all evidence (sculpt/evidence) is then weighed by a minimum cut
// (sculpt/labels). On well-sampled surfaces the boundary of its labels is a 2-manifold through all
// vertices as it stands. What is left to do elsewhere, sculpt/mend_surface does. Figures of this
// and of other ways are in bench/RESULTS.md.
#include "sculpt/sculpt_guided.h"

#include <algorithm>
#include <utility>

#include "sculpt/circumspheres.h"
#include "sculpt/deform.h"
#include "sculpt/evidence.h"
#include "sculpt/first_guess.h"
#include "sculpt/label_graph.h"
#include "sculpt/labels.h"
#include "sculpt/mend_surface.h"
#include "sculpt/poles.h"

namespace tetsculpt {
namespace {

/// Up to one hidden vertex in so many is brought out without new labels, if single flips do it.
constexpr std::size_t kManyPerFewHidden = 1024;

/// Of the work, where labels alone are no surface; it is all of it where they are.
constexpr double kUntilMended = 0.4;

bool any(const Flags& flags) { return std::find(flags.begin(), flags.end(), 1) != flags.end(); }

/// True if the cut's labels are a surface through all vertices as they stand or after a few single
/// flips, which are made.
bool is_surface(CutLabels& cut, const TetComplex& complex, const Circumspheres& spheres) {
  auto& [hidden, bad] = cut.faults;
  if (!bad.empty()) return false;
  if (hidden.empty()) return true;
  return hidden.size() <= complex.vertex_count() / kManyPerFewHidden &&
         expose_hidden(complex, spheres, hidden, cut.inside).empty();
}

/// What is known before the cut.
struct Knowledge {
  Flags alone;  ///< tetrahedra that make a node each
  LabelGraph graph;
  Evidence evidence;
};

Knowledge gather(std::span<const Point3> points, const TetComplex& complex,
                 const Circumspheres& spheres, const Flags& egh_triangles,
                 const std::function<void(double)>& progress) {
  Knowledge known;
  const LargeArray<PolePair> pairs = poles(points, complex, spheres);
  progress(0.1);
  LargeArray<float> overlap = overlaps(complex, spheres);
  progress(0.15);
  known.graph = label_graph(complex, overlap, {});
  progress(0.2);
  known.alone = contradicted_tets(complex, known.graph, pairs);
  if (any(known.alone)) known.graph = label_graph(complex, overlap, known.alone);
  progress(0.25);
  const LargeArray<Side> guess = first_guess(known.graph, pairs);
  progress(0.3);
  known.evidence = weigh_evidence(points, complex, spheres, pairs, known.graph, guess,
                                  std::move(overlap), egh_triangles);
  return known;
}

}  // namespace

Sculpture sculpt_guided(std::span<const Point3> points, const TetComplex& complex,
                        const Flags& egh_triangles, const GuidedOptions& options) {
  const auto progress = [&](double done) {
    if (options.progress) options.progress(done);
  };
  const Circumspheres spheres(points, complex);
  progress(0.05);
  Knowledge known = gather(points, complex, spheres, egh_triangles, progress);
  progress(0.35);
  CutLabels cut = cut_labels(complex, known.graph, known.evidence);
  progress(kUntilMended);
  Flags labels = options.keep == GuidedOptions::Keep::kLabels ? cut.inside : Flags();
  if (is_surface(cut, complex, spheres)) {
    return {.solid = std::move(cut.inside), .labels = std::move(labels)};
  }
  Sculpture mended =
      mended_surface(complex, spheres, known.evidence, cut.faults, std::move(known.alone),
                     [&](double done) { progress(kUntilMended + (1 - kUntilMended) * done); });
  mended.labels = std::move(labels);
  return mended;
}

}  // namespace tetsculpt
