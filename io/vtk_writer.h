#pragma once

#include <span>

#include "io/atomic_file.h"
#include "io/attribute.h"
#include "io/precision.h"
#include "io/write_report.h"
#include "kernel/tet_mesh.h"
#include "kernel/triangle_mesh.h"

namespace tetsculpt {

/// Writes `mesh` as a legacy VTK file, version 3.0, binary (big endian): POLYDATA with the points
/// as double, or float for kSingle, and each attribute as POINT_DATA of its own name and type:
/// SCALARS of one component. Dropped are attributes whose names have blanks or are given twice.
/// Precondition of kSingle: every coordinate is a float. Throws IoError if it has more points than
/// the format's 32-bit indices count.  [VTK User's Guide, "Simple Legacy Formats"]
WriteReport write_vtk(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                      Precision precision, AtomicFile& out);

/// The same for an UNSTRUCTURED_GRID of tetrahedra, points as double, and CELL_DATA `inside`.
void write_vtk(const TetMesh& mesh, AtomicFile& out);

}  // namespace tetsculpt
