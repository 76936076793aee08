#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "io/attribute.h"
#include "io/mesh_format.h"
#include "io/precision.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

struct WriteMeshOptions {
  /// Empty: the extension of the path names it, in either case.
  std::optional<MeshFormat> format = {};
  /// Of coordinates in a PLY file. Precondition of kSingle: every coordinate is a float.
  Precision precision = Precision::kDouble;
  /// What goes along with the vertices, one value per point of the mesh, in formats that can hold
  /// it.
  std::span<const Attribute> attributes = {};
};

/// Writes `mesh` to a file: .ply (binary little endian), .obj, .off, .stl (binary), .wrl
/// (VRML 2.0).
///   (1) Read back, the coordinates are the same bit for bit; only STL rounds them to floats.
///   (2) The file appears whole or not at all, see io/atomic_file.h.
/// Throws IoError on an unknown extension, a failing disk, or a mesh that the format cannot hold.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path,
                const WriteMeshOptions& options = {});

/// write_mesh knows the extension of `path`.
bool writable_mesh_extension(const std::filesystem::path& path);

}  // namespace tetsculpt
