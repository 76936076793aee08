#include "io/mesh_format.h"

#include <array>
#include <utility>

#include "io/extension.h"

namespace tetsculpt {
namespace {

constexpr std::array<std::pair<std::string_view, MeshFormat>, 8> kFormats = {{
    {"ply", MeshFormat::kPly},
    {"obj", MeshFormat::kObj},
    {"off", MeshFormat::kOff},
    {"stl", MeshFormat::kStl},
    {"wrl", MeshFormat::kVrml},
    {"gltf", MeshFormat::kGltf},
    {"glb", MeshFormat::kGlb},
    {"vtk", MeshFormat::kVtk},
}};

}  // namespace

std::optional<MeshFormat> mesh_format_named(std::string_view name) {
  for (const auto& [known, format] : kFormats) {
    if (name == known) return format;
  }
  return std::nullopt;
}

std::optional<MeshFormat> mesh_format_of(const std::filesystem::path& path) {
  const std::string extension = lowercase_extension(path);
  if (extension.empty()) return std::nullopt;
  return mesh_format_named(std::string_view(extension).substr(1));
}

std::string mesh_format_extensions() {
  std::string all;
  for (const auto& [name, format] : kFormats) {
    all.append(all.empty() ? "." : " .").append(name);
  }
  return all;
}

}  // namespace tetsculpt
