#include "io/read_points.h"

#include "io/column_names.h"
#include "io/content_format.h"
#include "io/extension.h"
#include "io/file_content.h"
#include "io/io_error.h"
#include "io/las_reader.h"
#include "io/obj_reader.h"
#include "io/off_reader.h"
#include "io/pcd_reader.h"
#include "io/ply_reader.h"
#include "io/stl_reader.h"
#include "io/text_points.h"
#include "io/vtk_reader.h"

namespace tetsculpt {
namespace {

PointFormat format_of(std::string_view content, const std::filesystem::path& path,
                      const ReadPointsOptions& options) {
  if (const auto reason = known_as_unreadable(content)) throw IoError(path, *reason);
  if (options.format) return *options.format;
  if (const auto format = marked_format(content)) return *format;
  if (const auto format = point_format_of(path)) return *format;
  if (const auto format = apparent_format(content)) return *format;
  const std::string extension = lowercase_extension(path);
  throw IoError(path,
                "not a known kind of point file" +
                    (extension.size() < 2 ? "" : ", nor is the extension '" + extension + "'") +
                    " (known: " + point_format_extensions() + ")");
}

PointFile parse(std::string_view content, const std::filesystem::path& path, PointFormat format) {
  switch (format) {
    case PointFormat::kText:
      return parse_text_points(content, path);
    case PointFormat::kPts:
      return parse_text_points(content, path, TextColumns::kPts);
    case PointFormat::kObj:
      return parse_obj_points(content, path);
    case PointFormat::kOff:
      return parse_off_points(content, path);
    case PointFormat::kStl:
      return parse_stl_points(content, path);
    case PointFormat::kPcd:
      return parse_pcd_points(content, path);
    case PointFormat::kLas:
      return parse_las_points(content, path);
    case PointFormat::kVtk:
      return parse_vtk_points(content, path);
    case PointFormat::kPly:
      break;
  }
  return parse_ply_points(content, path);
}

}  // namespace

PointFile read_points(const std::filesystem::path& path, const ReadPointsOptions& options) {
  return parse_points(read_file(path).view(), path, options);
}

PointFile parse_points(std::string_view content, const std::filesystem::path& path,
                       const ReadPointsOptions& options) {
  const PointFormat format = format_of(content, path, options);
  PointFile file = parse(content, path, format);
  file.format = format;
  make_names_distinct(file.attributes);
  return file;
}

}  // namespace tetsculpt
