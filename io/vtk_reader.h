#pragma once

#include <filesystem>
#include <string_view>

#include "io/point_file.h"

namespace tetsculpt {

/// The points of a legacy VTK file (`# vtk DataFile`), ascii or binary: the data sets POLYDATA,
/// UNSTRUCTURED_GRID and STRUCTURED_GRID. Cells do not count.
///   (1) Arrays of point data become attributes of their type, those of several numbers name_0,
///       name_1, ...; NORMALS are nx, ny, nz; COLOR_SCALARS red, green, blue, alpha (uint8 in a
///       binary file, shares of 1 in an ascii one). Arrays of bits are left out.
/// Throws IoError with `path` and the line, or the byte behind binary data; other data sets,
/// arrays of text and sections that are not of the format are refused.
PointFile parse_vtk_points(std::string_view content, const std::filesystem::path& path);

}  // namespace tetsculpt
