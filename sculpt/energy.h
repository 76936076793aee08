#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

/// The whole energy of the labels. Cost: linear.
inline double energy(const TetComplex& complex, const Evidence& evidence, const Flags& inside) {
  double sum = 0;
  for (std::uint32_t t = 0; t < complex.triangle_count(); ++t) {
    const Facet f = complex.facet(TriangleId{t});
    if (inside[+f.tet] != inside[+complex.neighbor(f.tet, f.corner)]) {
      sum += evidence.facet_cost(TriangleId{t});
    }
  }
  for (std::size_t t = 0; t < complex.finite_tet_count(); ++t) {
    const double bias = evidence.inside_bias[t];
    sum += inside[t] ? std::max(-bias, 0.0) : std::max(bias, 0.0);
  }
  return sum;
}

}  // namespace tetsculpt
