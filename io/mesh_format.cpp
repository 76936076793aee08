#include "io/mesh_format.h"

#include "io/named_formats.h"

namespace tetsculpt {
namespace {

constexpr NamedFormats<MeshFormat, 8> kFormats = {{{
    {"ply", MeshFormat::kPly},
    {"obj", MeshFormat::kObj},
    {"off", MeshFormat::kOff},
    {"stl", MeshFormat::kStl},
    {"wrl", MeshFormat::kVrml},
    {"gltf", MeshFormat::kGltf},
    {"glb", MeshFormat::kGlb},
    {"vtk", MeshFormat::kVtk},
}}};

}  // namespace

std::optional<MeshFormat> mesh_format_named(std::string_view name) { return kFormats.named(name); }

std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& path) {
  return kFormats.of(path);
}

std::string mesh_format_extensions() { return kFormats.extensions(); }

}  // namespace tetsculpt
