#pragma once

#include <filesystem>
#include <string_view>

#include "io/mesh_file.h"

namespace tetsculpt {

/// The triangles of a glTF 2.0 asset, .gltf or .glb: all meshes of its scene, moved as their nodes
/// say (mirrored ones are turned, as the format demands). Buffers are the binary chunk, base64
/// texts, or files named relative to `path`.
///   (1) Primitives of one node with the same accessor of positions share its vertices; others have
///       their own, even where they touch. Vertices that were split for their normals or texture
///       stay split.
///   (2) A primitive without indices has no shared vertices, as STL: those of one position become
///       one, the first.
///   (3) kSingle if no node moves anything.
/// Without scenes, all nodes that are no children count; without nodes, all meshes. Primitives of
/// points and lines, skins and morph targets are left out.
/// Throws IoError with `path` and the line, in a .glb file the byte; strips, fans, sparse and
/// compressed data and positions that are not 32-bit floats are refused.
/// Cost: linear in the file and in the triangles of all nodes; without indices, a sort.
MeshFile parse_gltf_mesh(std::string_view content, const std::filesystem::path& path);

}  // namespace tetsculpt
