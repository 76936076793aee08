#pragma once

#include "kernel/edge_order.h"

namespace tetsculpt {

/// What holds the paper's sculptor back (criterion kConstrained only).
struct Constraints {
  Flags egh_triangles;  ///< per triangle of the complex; see kernel/gabriel.h
  Flags emst_edges;     ///< per edge of the complex; see kernel/emst.h
};

}  // namespace tetsculpt
