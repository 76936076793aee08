#pragma once

#include <span>

#include "kernel/point.h"
#include "kernel/triangle_mesh.h"
#include "sculpt/reconstruct.h"
#include "tools/arguments.h"

/// The page that --viewer asks for.
namespace tetsculpt::cli {

/// Writes it to arguments.viewer. `points` are the input of the reconstruction, which has kept
/// graphs and record. Throws IoError.
void write_viewer(const Arguments& arguments, std::span<const Point3> points,
                  const Reconstruction& result, const Topology& topology);

}  // namespace tetsculpt::cli
