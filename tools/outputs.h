#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/point_file.h"
#include "sculpt/reconstruct.h"
#include "tools/arguments.h"

/// The files a run writes.
namespace tetsculpt::cli {

/// Tries whether the files that are asked for can be made, before hours are spent on what goes
/// there. Throws IoError.
void try_outputs(const Arguments& arguments);

/// Writes a file of text. Throws IoError.
void write_text(const std::string& text, const std::filesystem::path& file);

/// Writes all but the statistics. `index_in_file` is where in the file the points that were
/// reconstructed stand. Returns lines that tell what the surface's file does not hold as it was.
/// Throws IoError.
std::vector<std::string> write_outputs(const Arguments& arguments, const PointFile& file,
                                       const Reconstruction& result, const Topology& topology,
                                       std::span<const std::size_t> index_in_file);

}  // namespace tetsculpt::cli
