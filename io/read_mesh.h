#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/mesh_file.h"

namespace tetsculpt {

/// Formats of files that meshes are read from.
enum class MeshSource { kPly, kObj, kOff, kStl, kVtk, kVrml, kGltf };

/// The format with this name: an extension without its dot, in lower case ("ply", "wrl").
std::optional<MeshSource> mesh_source_named(std::string_view name);

struct ReadMeshOptions {
  /// Empty: the extension of the path names it, in either case.
  std::optional<MeshSource> format = {};
};

/// Reads the vertices and faces of a file: .ply, .obj, .off, .stl, .vtk (legacy POLYDATA), .wrl
/// (VRML 2.0), .gltf and .glb (glTF 2.0; the two are told apart by their content).
///   (1) Every coordinate is the nearest double to what the file says.
///   (2) Polygons are cut into fans of triangles, see io/polygon_fan.h.
///   (3) Every index of a triangle is one of a point; nothing else is judged.
/// Throws IoError on an unknown extension, a file that cannot be read, or a broken one.
/// Cost: linear, for STL, and glTF without indices, a sort; the file is in memory while it is read.
MeshFile read_mesh(const std::filesystem::path& path, const ReadMeshOptions& options = {});

/// As read_mesh, from the bytes of a file; `path` is for messages, and for the format if the
/// options name none.
MeshFile parse_mesh(std::string_view content, const std::filesystem::path& path,
                    const ReadMeshOptions& options = {});

/// All names, in a fixed order, with dots: ".ply .obj ...".
std::string mesh_source_extensions();

}  // namespace tetsculpt
