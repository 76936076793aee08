#pragma once

#include <functional>
#include <set>

#include "tests/support/sculpt_replay.h"
#include "tests/support/sculpt_stages.h"

/// The paper's rules of removal, stated on corner triples (support/sculpt_replay).
namespace tetsculpt::testing {

/// The state of a solid under removal. Keeps a reference to the stages.
class Rules {
 public:
  explicit Rules(const Stages& stages);

  const Replay& replay() const { return replay_; }
  bool solid(TetId t) const { return !removed_.contains(t); }
  void remove(TetId t);

  /// Basic rules: one boundary face and the opposite vertex hidden, or two and the opposite edge.
  bool removable(TetId t) const;
  /// Removable, no boundary face in the EGH, and two faces' common edge not in the EMST.
  bool allowed(TetId t) const;
  /// Has two boundary faces, and their common edge is in the EMST.
  bool common_edge_in_tree(TetId t) const;
  /// Has an EMST edge that its removal would bring to the boundary.
  bool exposes_tree_edge(TetId t) const;
  /// No solid tetrahedron has the property.
  bool none(const std::function<bool(TetId)>& property) const;
  bool none(bool (Rules::*property)(TetId) const) const;

 private:
  bool in_tree(EndPoints edge) const { return tree_.contains(edge); }

  const Stages* stages_;
  Replay replay_;
  std::set<TetId> removed_;
  std::set<Corners> egh_;
  std::set<EndPoints> tree_;
};

}  // namespace tetsculpt::testing
