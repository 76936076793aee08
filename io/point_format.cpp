#include "io/point_format.h"

#include "io/named_formats.h"

namespace tetsculpt {
namespace {

constexpr NamedFormats<PointFormat, 12> kFormats = {{{
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
}}};

}  // namespace

std::optional<PointFormat> point_format_named(std::string_view name) {
  return kFormats.named(name);
}

std::optional<PointFormat> point_format_of(const std::filesystem::path& path) {
  return kFormats.of(path);
}

std::string_view point_format_name(PointFormat format) { return kFormats.name(format); }

std::string point_format_extensions() { return kFormats.extensions(); }

}  // namespace tetsculpt
