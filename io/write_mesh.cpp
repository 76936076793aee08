#include "io/write_mesh.h"

#include <algorithm>
#include <cassert>
#include <variant>

#include "io/atomic_file.h"
#include "io/extension.h"
#include "io/gltf_writer.h"
#include "io/io_error.h"
#include "io/obj_writer.h"
#include "io/off_writer.h"
#include "io/stl_writer.h"
#include "io/vrml_writer.h"
#include "io/vtk_writer.h"

namespace tetsculpt {
namespace {

MeshFormat format_of(const std::filesystem::path& path, const WriteMeshOptions& options) {
  if (options.format) return *options.format;
  if (const std::optional<MeshFormat> format = mesh_format_of(path)) return *format;
  throw IoError(path, "unknown extension '" + lowercase_extension(path) +
                          "' of a mesh file (known: " + mesh_format_extensions() + ")");
}

WriteReport write(const TriangleMesh& mesh, MeshFormat format, const WriteMeshOptions& options,
                  AtomicFile& out) {
  const std::span<const Attribute> attributes = options.attributes;
  switch (format) {
    case MeshFormat::kObj:
      return write_obj(mesh, attributes, out);
    case MeshFormat::kOff:
      return write_off(mesh, attributes, out);
    case MeshFormat::kStl:
      return write_stl(mesh, attributes, out);
    case MeshFormat::kVrml:
      return write_vrml(mesh, attributes, out);
    case MeshFormat::kGltf:
      return write_gltf(mesh, attributes, GltfContainer::kText, out);
    case MeshFormat::kGlb:
      return write_gltf(mesh, attributes, GltfContainer::kBinary, out);
    case MeshFormat::kVtk:
      return write_vtk(mesh, attributes, options.precision, out);
    case MeshFormat::kPly:
      break;
  }
  return write_ply(mesh, attributes, {options.ply_encoding, options.precision}, out);
}

void check([[maybe_unused]] const TriangleMesh& mesh,
           [[maybe_unused]] const WriteMeshOptions& options) {
  assert(std::ranges::all_of(options.attributes, [&](const Attribute& attribute) {
    return mesh.points.size() ==
           std::visit([](const auto& values) { return values.size(); }, attribute.values);
  }));
}

}  // namespace

WriteReport write_mesh(const TriangleMesh& mesh, const std::filesystem::path& path,
                       const WriteMeshOptions& options) {
  check(mesh, options);
  const MeshFormat format = format_of(path, options);
  AtomicFile out(path);
  WriteReport report = write(mesh, format, options, out);
  out.commit();
  return report;
}

WriteReport write_mesh_to_standard_output(const TriangleMesh& mesh,
                                          const WriteMeshOptions& options) {
  check(mesh, options);
  assert(options.format);
  AtomicFile out{StandardOutput{}};
  WriteReport report = write(mesh, *options.format, options, out);
  out.commit();
  return report;
}

bool writable_mesh_extension(const std::filesystem::path& path) {
  return mesh_format_of(path).has_value();
}

}  // namespace tetsculpt
