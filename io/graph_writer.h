#pragma once

#include <filesystem>
#include <span>

#include "io/precision.h"
#include "kernel/point.h"
#include "kernel/point_graph.h"

namespace tetsculpt {

/// Writes a graph to a PLY file (binary little endian): `element vertex`, `element edge` with
/// `vertex1` and `vertex2`, and `element face` if there are triangles.
/// Precondition of kSingle: every coordinate is a float. Throws IoError.
void write_graph(std::span<const Point3> points, const PointGraph& graph, Precision precision,
                 const std::filesystem::path& path);

}  // namespace tetsculpt
