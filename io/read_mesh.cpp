#include "io/read_mesh.h"

#include "io/extension.h"
#include "io/file_content.h"
#include "io/gltf_mesh.h"
#include "io/io_error.h"
#include "io/named_formats.h"
#include "io/obj_mesh.h"
#include "io/off_mesh.h"
#include "io/ply_mesh.h"
#include "io/stl_mesh.h"
#include "io/vrml_mesh.h"
#include "io/vtk_mesh.h"

namespace tetsculpt {
namespace {

constexpr NamedFormats<MeshSource, 8> kFormats = {{{
    {"ply", MeshSource::kPly},
    {"obj", MeshSource::kObj},
    {"off", MeshSource::kOff},
    {"stl", MeshSource::kStl},
    {"vtk", MeshSource::kVtk},
    {"wrl", MeshSource::kVrml},
    {"gltf", MeshSource::kGltf},
    {"glb", MeshSource::kGltf},
}}};

MeshSource format_of(const std::filesystem::path& path, const ReadMeshOptions& options) {
  if (options.format) return *options.format;
  if (const auto format = kFormats.of(path)) return *format;
  throw IoError(path, "unknown extension '" + lowercase_extension(path) +
                          "' of a mesh file (known: " + mesh_source_extensions() + ")");
}

MeshFile parse(std::string_view content, const std::filesystem::path& path, MeshSource format) {
  switch (format) {
    case MeshSource::kObj:
      return parse_obj_mesh(content, path);
    case MeshSource::kOff:
      return parse_off_mesh(content, path);
    case MeshSource::kStl:
      return parse_stl_mesh(content, path);
    case MeshSource::kVtk:
      return parse_vtk_mesh(content, path);
    case MeshSource::kVrml:
      return parse_vrml_mesh(content, path);
    case MeshSource::kGltf:
      return parse_gltf_mesh(content, path);
    case MeshSource::kPly:
      break;
  }
  return parse_ply_mesh(content, path);
}

}  // namespace

std::optional<MeshSource> mesh_source_named(std::string_view name) { return kFormats.named(name); }

MeshFile read_mesh(const std::filesystem::path& path, const ReadMeshOptions& options) {
  const MeshSource format = format_of(path, options);
  return parse(read_file(path).view(), path, format);
}

MeshFile parse_mesh(std::string_view content, const std::filesystem::path& path,
                    const ReadMeshOptions& options) {
  return parse(content, path, format_of(path, options));
}

std::string mesh_source_extensions() { return kFormats.extensions(); }

}  // namespace tetsculpt
