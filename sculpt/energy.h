#pragma once

#include <span>

#include "kernel/edge_order.h"
#include "kernel/tet_complex.h"
#include "sculpt/evidence.h"

/// The energy of labels.
namespace tetsculpt {

/// By how much the energy changes if one finite tetrahedron changes sides.
inline double flip_cost(const TetComplex& complex, const Evidence& evidence, const Flags& inside,
                        TetId t) {
  double change = inside[+t] ? evidence.inside_bias[+t] : -evidence.inside_bias[+t];
  for (int i = 0; i < 4; ++i) {
    const double cost = evidence.facet_cost(complex.triangle(t, i));
    change += inside[+complex.neighbor(t, i)] == inside[+t] ? cost : -cost;
  }
  return change;
}

}  // namespace tetsculpt
