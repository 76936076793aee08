#include "io/read_points.h"

#include "io/extension.h"
#include "io/file_content.h"
#include "io/io_error.h"
#include "io/obj_reader.h"
#include "io/off_reader.h"
#include "io/ply_reader.h"
#include "io/text_points.h"

namespace tetsculpt {
namespace {

PointFormat format_of(const std::filesystem::path& path, const ReadPointsOptions& options) {
  if (options.format) return *options.format;
  if (const std::optional<PointFormat> format = point_format_of(path)) return *format;
  throw IoError(path, "unknown extension '" + lowercase_extension(path) +
                          "' of a point file (known: " + point_format_extensions() + ")");
}

PointFile parse(std::string_view content, const std::filesystem::path& path, PointFormat format) {
  switch (format) {
    case PointFormat::kText:
      return parse_text_points(content, path);
    case PointFormat::kObj:
      return parse_obj_points(content, path);
    case PointFormat::kOff:
      return parse_off_points(content, path);
    case PointFormat::kPly:
      break;
  }
  return parse_ply_points(content, path);
}

}  // namespace

PointFile read_points(const std::filesystem::path& path, const ReadPointsOptions& options) {
  const PointFormat format = format_of(path, options);
  return parse(read_file(path).view(), path, format);
}

PointFile parse_points(std::string_view content, const std::filesystem::path& path,
                       const ReadPointsOptions& options) {
  return parse(content, path, format_of(path, options));
}

}  // namespace tetsculpt
