// Sculpting after M. Attene, M. Spagnuolo, "Automatic surface reconstruction from point sets in
// space", Computer Graphics Forum 19(3), 2000, section 3. Where the paper leaves a choice:
//  - Step 1 runs until the queue is empty. The paper stops it once all vertices are on the
//    boundary; that leaves concavities filled (a sampled cube of 2000 points: 53 false handles
//    afterwards).
//  - Step 2, vertices still hidden, lifts the EGH constraint first and takes tetrahedra with one
//    boundary face first, longest edge first: each of them exposes a vertex. Only if that does not
//    suffice, the EMST constraint is lifted too. Then step 1 runs once more.
//  - Step 3, tree edges still inside, removes tetrahedra by the basic rules that bring one out.
//  - Step 4 opens one hole, by the pseudo-prism with the longest boundary edge, and returns to
//  step 1.
// The unconstrained criteria remove until every vertex is on the boundary, and do nothing else.
//
// Each step keeps its place in a log of tetrahedra whose boundary faces changed, so that going
// round again looks only at what is new: an entry that was not removable can only become so by such
// a change. One that was touched again later waits until then.
//
// What it costs is memory: places that no cache is near to, one of which leads to the next. Three
// things took a third off, on 65,536 points of a bumpy sphere: all that is known of a tetrahedron
// in one line of the cache (sculpt/manifold_solid); the next of the queue and its neighbours on
// their way there ahead; and the log begun anew after the first step, in the order of memory,
// because each other step reads all of it, and most entries are out of date by then. Without gain:
// to look further ahead than the next of the queue.
#include "sculpt/sculpt_paper.h"

#include <algorithm>
#include <array>
#include <bit>

#include "sculpt/manifold_solid.h"
#include "sculpt/pseudo_prism.h"
#include "sculpt/removal_queue.h"

namespace tetsculpt {
namespace {

enum class Step { kUnconstrained, kConstrained, kEghLifted, kAllLifted, kExposeTree };
constexpr std::size_t kSteps = 5;
/// How far ahead of the place in the log memory is asked for.
constexpr std::size_t kAhead = 16;

template <class Queue>
class PaperSculptor {
 public:
  PaperSculptor(std::span<const Point3> points, const TetComplex& complex,
                const Constraints& constraints, const PaperOptions& options)
      : options_(options),
        solid_(points, complex, constraints),
        priority_(options.criterion, points, solid_),
        queue_(solid_, complex.edge_count()) {
    // At first the boundary is what the infinite tetrahedra touch.
    for (std::size_t t = complex.finite_tet_count(); t < complex.tet_count(); ++t) {
      const TetId outside{static_cast<std::uint32_t>(t)};
      touch(complex.neighbor(outside, corner_of(complex.vertices(outside), kInfinite)));
    }
  }

  Sculpture run();

 private:
  struct PrismEntry {
    std::uint32_t rank;
    PseudoPrism prism;
  };

  /// How t meets the boundary, counted as one look.
  Exposure look(TetId t) {
    ++out_.work.looks;
    return exposure(solid_, t);
  }
  /// Its facets on the boundary, as bits; a look, too.
  unsigned faces(TetId t) {
    ++out_.work.looks;
    return solid_.faces(t);
  }
  void run_step(Step step);
  bool current(Step step, const RemovalEntry& entry);
  bool done(Step step) const;
  bool allowed(Step step, TetId t, const Exposure& e) const;
  bool common_edge_in_tree(TetId t, const Exposure& e) const;
  bool exposes_tree_edge(TetId t, const Exposure& e) const;
  double key(Step step, TetId t, const Exposure& e) const;
  void push(Step step, TetId t);
  void push_touched(Step step);
  void restart_log();
  void touch(TetId t);
  bool is_last_touch(std::size_t k) const { return solid_.note(touched_[k]) == k; }
  void note_removal(TetId t);
  bool open_hole();
  void find_prisms();
  bool before(const PrismEntry& a, const PrismEntry& b) const;
  std::uint32_t prism_rank(const PseudoPrism& prism);

  const PaperOptions& options_;
  ManifoldSolid solid_;  ///< its note of a tetrahedron is the last place in the log
  Priority priority_;
  Queue queue_;
  std::vector<PrismEntry> prisms_;          ///< a heap by before()
  std::vector<TetId> touched_;              ///< log: their boundary faces changed
  std::array<std::size_t, kSteps> seen_{};  ///< per step, how much of the log it has seen
  std::size_t seen_by_prisms_ = 0;
  Sculpture out_;
};

template <class Queue>
Sculpture PaperSculptor<Queue>::run() {
  if (options_.criterion != Criterion::kConstrained) {
    run_step(Step::kUnconstrained);
  } else {
    run_step(Step::kConstrained);
    restart_log();
    do {
      run_step(Step::kConstrained);
      if (solid_.hidden_count() > 0) {
        run_step(Step::kEghLifted);
        run_step(Step::kAllLifted);
        run_step(Step::kConstrained);
      }
      run_step(Step::kExposeTree);
    } while (open_hole());
  }
  out_.solid = solid_.solid();
  out_.hidden = solid_.hidden_vertices();
  return std::move(out_);
}

/// Removes what the step allows, in the order of its queue, until nothing is left or it is done.
template <class Queue>
void PaperSculptor<Queue>::run_step(Step step) {
  if (done(step)) return;
  queue_.clear();
  push_touched(step);
  while (!done(step) && !queue_.empty()) {
    const RemovalEntry entry = queue_.pop();
    solid_.prefetch_neighbors(entry.tet);
    ++out_.work.pops;
    if (!current(step, entry)) {
      ++out_.work.stale;
      continue;
    }
    solid_.remove(entry.tet, [&](TetId changed) { touch(changed); });
    note_removal(entry.tet);
    if (!queue_.empty()) solid_.prefetch(queue_.next());
    push_touched(step);
    if (!queue_.empty()) solid_.prefetch_neighbors(queue_.next());
  }
}

/// Would the entry be pushed again as it is?
template <class Queue>
bool PaperSculptor<Queue>::current(Step step, const RemovalEntry& entry) {
  if (!solid_.solid(entry.tet)) return false;
  const Exposure e = look(entry.tet);
  return allowed(step, entry.tet, e) && key(step, entry.tet, e) == entry.key;
}

template <class Queue>
bool PaperSculptor<Queue>::done(Step step) const {
  switch (step) {
    case Step::kConstrained:
      return options_.stop == PaperOptions::Stop::kAllExposed && solid_.hidden_count() == 0;
    case Step::kExposeTree:
      return false;
    default:
      return solid_.hidden_count() == 0;
  }
}

template <class Queue>
bool PaperSculptor<Queue>::allowed(Step step, TetId t, const Exposure& e) const {
  if (!e.removable) return false;
  switch (step) {
    case Step::kConstrained:
      return (solid_.egh_facets(t) & e.facets) == 0 && !common_edge_in_tree(t, e);
    case Step::kEghLifted:
      return !common_edge_in_tree(t, e);
    case Step::kExposeTree:
      return exposes_tree_edge(t, e);
    default:
      return true;
  }
}

/// With two boundary faces, is their common edge in the EMST?
template <class Queue>
bool PaperSculptor<Queue>::common_edge_in_tree(TetId t, const Exposure& e) const {
  return e.faces == 2 && solid_.in_emst(t, 5 - e.opposite_edge);
}

/// Would the removal of t bring an edge of the EMST to the boundary?
template <class Queue>
bool PaperSculptor<Queue>::exposes_tree_edge(TetId t, const Exposure& e) const {
  // An edge comes out with the removal if it is on none of the boundary faces.
  for (unsigned left = kEdgesInside[e.facets]; left != 0; left &= left - 1) {
    const int k = std::countr_zero(left);
    if (solid_.in_emst(t, k) && !solid_.edge_on_boundary(t, k)) return true;
  }
  return false;
}

template <class Queue>
double PaperSculptor<Queue>::key(Step step, TetId t, const Exposure& e) const {
  const bool exposing = step == Step::kEghLifted || step == Step::kAllLifted;
  return priority_.key(t, e) + (exposing && e.faces == 2 ? kBehindAll : 0);
}

template <class Queue>
void PaperSculptor<Queue>::push(Step step, TetId t) {
  if (!solid_.solid(t)) return;
  const Exposure e = look(t);
  if (!allowed(step, t, e)) return;
  queue_.push({key(step, t, e), t});
  ++out_.work.pushes;
}

template <class Queue>
void PaperSculptor<Queue>::push_touched(Step step) {
  std::size_t& seen = seen_[static_cast<std::size_t>(step)];
  for (; seen < touched_.size(); ++seen) {
    if (seen + kAhead < touched_.size()) solid_.prefetch(touched_[seen + kAhead]);
    if (is_last_touch(seen)) push(step, touched_[seen]);
  }
}

/// Begins the log anew with what the steps other than the first have to look at: all that has
/// boundary faces, in the order of memory. Precondition: they have not begun.
template <class Queue>
void PaperSculptor<Queue>::restart_log() {
  touched_.clear();
  for (std::uint32_t t = 0; t < solid_.complex().finite_tet_count(); ++t) {
    if (solid_.solid(TetId{t}) && solid_.faces(TetId{t}) != 0) touch(TetId{t});
  }
  seen_[static_cast<std::size_t>(Step::kConstrained)] = touched_.size();
}

template <class Queue>
void PaperSculptor<Queue>::touch(TetId t) {
  solid_.note(t) = static_cast<std::uint32_t>(touched_.size());
  touched_.push_back(t);
}

template <class Queue>
void PaperSculptor<Queue>::note_removal(TetId t) {
  out_.removed.push_back(t);
  if (options_.progress && (out_.removed.size() & 0xffff) == 0) {
    options_.progress(1 - static_cast<double>(solid_.hidden_count()) /
                              static_cast<double>(solid_.complex().vertex_count()));
  }
}

/// Removes the pseudo-prism with the longest boundary edge, if there is any.
template <class Queue>
bool PaperSculptor<Queue>::open_hole() {
  find_prisms();
  const auto later = [&](const PrismEntry& a, const PrismEntry& b) { return before(b, a); };
  while (!prisms_.empty()) {
    std::pop_heap(prisms_.begin(), prisms_.end(), later);
    const PseudoPrism prism = prisms_.back().prism;
    prisms_.pop_back();
    if (!is_pseudo_prism(solid_, prism)) continue;
    out_.holes.push_back(out_.removed.size());
    solid_.remove_prism(prism.tets, [&](TetId changed) { touch(changed); });
    for (const TetId t : prism.tets) note_removal(t);
    return true;
  }
  return false;
}

/// Looks for pseudo-prisms on the boundary faces that are new. A chain that is none cannot become
/// one unless a base is: coastal edges never leave the boundary while the chain is solid.
template <class Queue>
void PaperSculptor<Queue>::find_prisms() {
  const auto later = [&](const PrismEntry& a, const PrismEntry& b) { return before(b, a); };
  for (; seen_by_prisms_ < touched_.size(); ++seen_by_prisms_) {
    const TetId t = touched_[seen_by_prisms_];
    if (!solid_.solid(t) || !is_last_touch(seen_by_prisms_)) continue;
    for (unsigned left = faces(t); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      ++out_.work.bases;
      for (const PseudoPrism& prism : pseudo_prisms(solid_, t, i)) {
        prisms_.push_back({prism_rank(prism), prism});
        ++out_.work.prisms;
        std::push_heap(prisms_.begin(), prisms_.end(), later);
      }
    }
  }
}

template <class Queue>
std::uint32_t PaperSculptor<Queue>::prism_rank(const PseudoPrism& prism) {
  std::uint32_t rank = 0;
  for (const TetId t : {prism.tets[0], prism.tets[2]}) {
    rank = std::max(rank, solid_.longest_rank(t, faces(t)));
  }
  return rank;
}

/// The order of prisms: longest boundary edge first, then lexicographic order of the tetrahedra,
/// the two ends of a chain taken in that order, too.
template <class Queue>
bool PaperSculptor<Queue>::before(const PrismEntry& a, const PrismEntry& b) const {
  if (a.rank != b.rank) return a.rank > b.rank;
  const auto less = [&](TetId t, TetId u) {
    return corners_less(solid_.vertices(t), solid_.vertices(u));
  };
  const auto ordered = [&](PseudoPrism p) {
    if (less(p.tets[2], p.tets[0])) std::swap(p.tets[0], p.tets[2]);
    return p;
  };
  const PseudoPrism p = ordered(a.prism);
  const PseudoPrism q = ordered(b.prism);
  for (std::size_t i = 0; i < 3; ++i) {
    if (p.tets[i] != q.tets[i]) return less(p.tets[i], q.tets[i]);
  }
  return false;
}

}  // namespace

Sculpture sculpt_paper(std::span<const Point3> points, const TetComplex& complex,
                       const Constraints& constraints, const PaperOptions& options) {
  if (is_by_rank(options.criterion)) {
    return PaperSculptor<RankQueue>(points, complex, constraints, options).run();
  }
  return PaperSculptor<KeyQueue>(points, complex, constraints, options).run();
}

}  // namespace tetsculpt
