#include "io/write_mesh.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "io/atomic_file.h"
#include "io/extension.h"
#include "io/io_error.h"
#include "io/obj_writer.h"
#include "io/off_writer.h"
#include "io/ply_writer.h"
#include "io/stl_writer.h"
#include "io/vrml_writer.h"

namespace tetsculpt {

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path,
                const WriteMeshOptions& options) {
  const std::string extension = lowercase_extension(path);
  if (!writable_mesh_extension(path)) {
    throw IoError(path, "unknown extension '" + extension +
                            "' of a mesh file (known: .ply .obj .off .stl .wrl)");
  }
  AtomicFile out(path);
  if (extension == ".ply") write_ply(mesh, options.precision, out);
  if (extension == ".obj") write_obj(mesh, out);
  if (extension == ".off") write_off(mesh, out);
  if (extension == ".stl") write_stl(mesh, path, out);
  if (extension == ".wrl") write_vrml(mesh, out);
  out.commit();
}

bool writable_mesh_extension(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 5> kKnown = {".ply", ".obj", ".off", ".stl", ".wrl"};
  return std::ranges::find(kKnown, lowercase_extension(path)) != kKnown.end();
}

}  // namespace tetsculpt
