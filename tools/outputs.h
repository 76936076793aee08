#pragma once

#include <filesystem>
#include <string>

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

/// Writes all but the statistics. Throws IoError.
void write_outputs(const Arguments& arguments, const Reconstruction& result, Precision precision);

}  // namespace tetsculpt::cli
