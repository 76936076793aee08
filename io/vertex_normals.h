#pragma once

#include <vector>

#include "io/attribute.h"
#include "kernel/triangle_mesh.h"
#include "kernel/vec3.h"

namespace tetsculpt {

/// Per point the outward unit normal of the surface: the mean of its triangles' unit normals, each
/// weighted by the triangle's angle at the point, so that it hardly depends on how the surface is
/// cut into triangles.  [Thurmer, Wuthrich 1998; Baerentzen, Aanaes 2005]
///   (1) Where they cancel it is the normal of the first triangle with an area; zero if there is
///       none.   (2) Any size of finite coordinates.   (3) No threads: the same mesh, the same
///       bits.
/// Precondition: indices are of points. Cost: linear.
std::vector<Vec3<double>> vertex_normals(const TriangleMesh& mesh);

/// They as attributes nx, ny, nz of type float.
std::vector<Attribute> vertex_normal_attributes(const TriangleMesh& mesh);

}  // namespace tetsculpt
