#include "io/point_format.h"

#include <array>
#include <utility>

#include "io/extension.h"

namespace tetsculpt {
namespace {

constexpr std::array<std::pair<std::string_view, PointFormat>, 12> kFormats = {{
    {"xyz", PointFormat::kText},
    {"txt", PointFormat::kText},
    {"csv", PointFormat::kText},
    {"pts", PointFormat::kPts},
    {"asc", PointFormat::kText},
    {"ply", PointFormat::kPly},
    {"obj", PointFormat::kObj},
    {"off", PointFormat::kOff},
    {"stl", PointFormat::kStl},
    {"pcd", PointFormat::kPcd},
    {"las", PointFormat::kLas},
    {"vtk", PointFormat::kVtk},
}};

}  // namespace

std::optional<PointFormat> point_format_named(std::string_view name) {
  for (const auto& [known, format] : kFormats) {
    if (name == known) return format;
  }
  return std::nullopt;
}

std::optional<PointFormat> point_format_of(const std::filesystem::path& path) {
  const std::string extension = lowercase_extension(path);
  if (extension.empty()) return std::nullopt;
  return point_format_named(std::string_view(extension).substr(1));
}

std::string point_format_extensions() {
  std::string all;
  for (const auto& [name, format] : kFormats) {
    all.append(all.empty() ? "." : " .").append(name);
  }
  return all;
}

}  // namespace tetsculpt
