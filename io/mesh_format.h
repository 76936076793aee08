#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tetsculpt {

/// Formats of files that meshes are written to.
enum class MeshFormat { kPly, kObj, kOff, kStl, kVrml, kGltf, kGlb, kVtk };

/// The format with this name: an extension without its dot, in lower case ("ply", "wrl").
std::optional<MeshFormat> mesh_format_named(std::string_view name);

/// The format that the extension of `path` names, in either case.
std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& path);

/// All names, in a fixed order, with dots: ".ply .obj ...".
std::string mesh_format_extensions();

}  // namespace tetsculpt
