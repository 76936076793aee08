#include "bench/peer_qhull.h"

#include <cstdio>
#include <stdexcept>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace tetsculpt::bench {

std::size_t qhull_tetrahedra(const std::vector<Point3>& points) {
  std::vector<coordT> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point3& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  qhT memory;
  qhT* const qh = &memory;
  qh_zero(qh, stderr);
  char options[] = "qhull d Qbb Qc Qz";
  if (qh_new_qhull(qh, 3, static_cast<int>(points.size()), coordinates.data(), False, options,
                   nullptr, nullptr) != 0) {
    throw std::runtime_error("Qhull failed");
  }
  std::size_t count = 0;
  facetT* facet;
  FORALLfacets count += !facet->upperdelaunay;
  qh_freeqhull(qh, qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(qh, &current, &total);
  return count;
}

}  // namespace tetsculpt::bench
