#pragma once

#include <filesystem>

#include "kernel/tet_mesh.h"

namespace tetsculpt {

/// Writes tetrahedra, with corners in the order that gives them a positive volume there: .vtk
/// (legacy, binary, an unstructured grid with CELL_DATA `inside`) or .mesh (Medit text, the
/// reference of a tetrahedron is 1 inside and 0 outside).
///   (1) The coordinates read back the same bit for bit.
///   (2) The file appears whole or not at all, see io/atomic_file.h.
/// Precondition: indices are of points, one `inside` per tetrahedron. Throws IoError on another
/// extension, a failing disk, or more points than the format can index.
void write_tetrahedra(TetMesh mesh, const std::filesystem::path& path);

/// write_tetrahedra knows the extension of `path`, in either case.
bool writable_tetrahedra_extension(const std::filesystem::path& path);

}  // namespace tetsculpt
