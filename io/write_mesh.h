#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "io/attribute.h"
#include "io/mesh_format.h"
#include "io/ply_writer.h"
#include "io/precision.h"
#include "io/write_report.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

struct WriteMeshOptions {
  /// Empty: the extension of the path names it, in either case.
  std::optional<MeshFormat> format = {};
  /// Of coordinates in PLY and VTK files. Precondition of kSingle: every coordinate is a float.
  Precision precision = Precision::kDouble;
  PlyEncoding ply_encoding = PlyEncoding::kBinary;
  /// What goes along with the vertices, one value per point of the mesh, where the format can hold
  /// it; vertex_normal_attributes() makes nx, ny, nz.
  std::span<const Attribute> attributes = {};
};

/// Writes `mesh` to a file: .ply, .obj, .off, .stl (binary), .wrl (VRML 2.0), .gltf (one text),
/// .glb or .vtk (legacy, binary). Each writer's header says how attributes are held.
///   (1) Read back, the coordinates are the same bit for bit, as are attributes in PLY and VTK
///   files.
///       Only STL and glTF round them to floats; the report names what was rounded and dropped.
///   (2) The file appears whole or not at all, see io/atomic_file.h.
/// Throws IoError on an unknown extension, a failing disk, or a mesh that the format cannot hold.
WriteReport write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path,
                       const WriteMeshOptions& options = {});

/// The same to standard output. Precondition: options.format is given. A failure leaves a part.
WriteReport write_mesh_to_standard_output(const TriangleMesh& mesh,
                                          const WriteMeshOptions& options);

/// write_mesh knows the extension of `path`.
bool writable_mesh_extension(const std::filesystem::path& path);

}  // namespace tetsculpt
