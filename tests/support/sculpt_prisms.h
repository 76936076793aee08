#pragma once

#include <array>
#include <set>
#include <vector>

#include "tests/support/sculpt_rules.h"

/// Pseudo-prisms by definition, on corner triples (support/sculpt_replay).
namespace tetsculpt::testing {

/// Three solid tetrahedra in a row, each sharing a facet with the next.
using Chain = std::array<TetId, 3>;

/// All chains, each in both directions.
std::vector<Chain> all_chains(const Stages& stages, const Rules& rules);

/// Six vertices, the bases on the boundary, coastal triangles and edges not, one of these flagged.
bool is_prism(const Stages& stages, const Rules& rules, const Chain& chain,
              const std::set<EndPoints>& flagged);

/// The flagged edges by their end points.
std::set<EndPoints> end_points(const Stages& stages, const Flags& flagged);

}  // namespace tetsculpt::testing
