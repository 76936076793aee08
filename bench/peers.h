#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "kernel/point.h"

/// Other programs' Delaunay tetrahedralizations.
namespace tetsculpt::bench {

struct Peer {
  std::string name;
  /// Makes the tetrahedralization and returns its number of tetrahedra.
  std::function<std::size_t(const std::vector<Point3>&)> tetrahedra;
  std::size_t most_points;  ///< with more it takes too long to wait for
};

/// Those that were found when this was built, maybe none.
std::vector<Peer> peers();

}  // namespace tetsculpt::bench
