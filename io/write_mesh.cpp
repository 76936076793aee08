#include "io/write_mesh.h"

#include "io/atomic_file.h"
#include "io/extension.h"
#include "io/io_error.h"
#include "io/obj_writer.h"
#include "io/off_writer.h"
#include "io/ply_writer.h"
#include "io/stl_writer.h"
#include "io/vrml_writer.h"

namespace tetsculpt {
namespace {

MeshFormat format_of(const std::filesystem::path& path, const WriteMeshOptions& options) {
  if (options.format) return *options.format;
  if (const std::optional<MeshFormat> format = mesh_format_of(path)) return *format;
  throw IoError(path, "unknown extension '" + lowercase_extension(path) +
                          "' of a mesh file (known: " + mesh_format_extensions() + ")");
}

}  // namespace

void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path,
                const WriteMeshOptions& options) {
  const MeshFormat format = format_of(path, options);
  AtomicFile out(path);
  switch (format) {
    case MeshFormat::kPly:
      write_ply(mesh, options.precision, out);
      break;
    case MeshFormat::kObj:
      write_obj(mesh, out);
      break;
    case MeshFormat::kOff:
      write_off(mesh, out);
      break;
    case MeshFormat::kStl:
      write_stl(mesh, path, out);
      break;
    case MeshFormat::kVrml:
      write_vrml(mesh, out);
      break;
  }
  out.commit();
}

bool writable_mesh_extension(const std::filesystem::path& path) {
  return mesh_format_of(path).has_value();
}

}  // namespace tetsculpt
