#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/attribute.h"
#include "io/point_file.h"
#include "sculpt/reconstruct.h"
#include "tools/arguments.h"

/// The surface on its way out.
namespace tetsculpt::cli {

/// The attributes of the points of a file as those of the surface's vertices: a vertex has the
/// values of the first of its input points. `index_in_file` is where in the file the points that
/// were reconstructed stand.
std::vector<Attribute> vertex_attributes(std::span<const Attribute> of_file,
                                         const Reconstruction& result,
                                         std::span<const std::size_t> index_in_file);

/// Writes the surface with its attributes as the arguments want it. Returns lines that tell what
/// the file does not hold as it was. Throws IoError.
std::vector<std::string> write_surface(const Arguments& arguments, const PointFile& file,
                                       const Reconstruction& result,
                                       std::span<const std::size_t> index_in_file);

}  // namespace tetsculpt::cli
