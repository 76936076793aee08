#pragma once

#include <cstddef>
#include <functional>

#include "bench/paper_stages.h"
#include "kernel/point.h"
#include "kernel/triangle_mesh.h"

/// What Figure 6 compares surfaces by.
namespace tetsculpt::bench {

double surface_area(const TriangleMesh& mesh);
/// Triangles with an angle of less than ten degrees.
std::size_t sharp_triangles(const TriangleMesh& mesh);

struct DistanceToTruth {
  double mean = 0;  ///< over the area of the mesh
  double largest = 0;
};
/// Measured at 36 places per triangle.
DistanceToTruth distance_to_truth(const TriangleMesh& mesh,
                                  const std::function<double(const Point3&)>& distance);

/// How many edges of the points' Euclidean minimum spanning tree are no edge of the mesh. The
/// mesh's points are among the stages'.
std::size_t tree_edges_off(const PaperStages& stages, const TriangleMesh& mesh);

}  // namespace tetsculpt::bench
