#include "io/tetrahedra_writer.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "io/atomic_file.h"
#include "io/extension.h"
#include "io/io_error.h"
#include "io/text_rows.h"
#include "io/vtk_writer.h"

namespace tetsculpt {
namespace {

void add_section(std::string_view word, std::size_t count, TextRows& rows) {
  rows.add(word);
  rows.add("\n");
  rows.add_number(count);
  rows.add("\n");
}

// Version 2 has coordinates of double precision. Indices count from 1.
void write_medit(const TetMesh& mesh, AtomicFile& out) {
  TextRows rows(out);
  rows.add("MeshVersionFormatted 2\nDimension 3\n");
  add_section("Vertices", mesh.points.size(), rows);
  for (const Point3& point : mesh.points) {
    rows.add_point(point);
    rows.add(" 0\n");
  }
  add_section("Tetrahedra", mesh.tetrahedra.size(), rows);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    for (const std::uint32_t corner : mesh.tetrahedra[t]) {
      rows.add_number(std::uint64_t{corner} + 1);
      rows.add(" ");
    }
    rows.add(mesh.inside[t] != 0 ? "1\n" : "0\n");
  }
  rows.add("End\n");
  rows.finish();
}

}  // namespace

void write_tetrahedra(TetMesh mesh, const std::filesystem::path& path) {
  assert(mesh.inside.size() == mesh.tetrahedra.size());
  if (!writable_tetrahedra_extension(path)) {
    throw IoError(path, "unknown extension '" + lowercase_extension(path) +
                            "' of a file of tetrahedra (known: .vtk .mesh)");
  }
  // A positive orient3d is a negative volume.
  for (auto& corners : mesh.tetrahedra) std::swap(corners[2], corners[3]);
  AtomicFile out(path);
  if (lowercase_extension(path) == ".vtk") {
    write_vtk(mesh, out);
  } else {
    write_medit(mesh, out);
  }
  out.commit();
}

bool writable_tetrahedra_extension(const std::filesystem::path& path) {
  const std::string extension = lowercase_extension(path);
  return extension == ".vtk" || extension == ".mesh";
}

}  // namespace tetsculpt
