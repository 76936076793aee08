#include "bench/peer_cgal.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace tetsculpt::bench {

std::size_t cgal_tetrahedra(const std::vector<Point3>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> own;
  own.reserve(points.size());
  for (const Point3& p : points) own.emplace_back(p.x, p.y, p.z);
  return CGAL::Delaunay_triangulation_3<Kernel>(own.begin(), own.end()).number_of_finite_cells();
}

}  // namespace tetsculpt::bench
