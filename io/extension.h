#pragma once

#include <filesystem>
#include <string>

namespace tetsculpt {

/// The extension of `path` with its dot, A-Z in lower case: ".ply" for "Bunny.PLY".
std::string lowercase_extension(const std::filesystem::path& path);

}  // namespace tetsculpt
