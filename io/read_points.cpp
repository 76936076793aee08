#include "io/read_points.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "io/extension.h"
#include "io/file_content.h"
#include "io/io_error.h"
#include "io/obj_reader.h"
#include "io/off_reader.h"
#include "io/ply_reader.h"
#include "io/text_points.h"

namespace tetsculpt {
namespace {

bool is_text_extension(std::string_view extension) {
  constexpr std::array<std::string_view, 5> kText = {".xyz", ".txt", ".csv", ".pts", ".asc"};
  return std::ranges::find(kText, extension) != kText.end();
}

}  // namespace

PointFile read_points(const std::filesystem::path& path) {
  const std::string extension = lowercase_extension(path);
  const bool text = is_text_extension(extension);
  if (!text && extension != ".ply" && extension != ".obj" && extension != ".off") {
    throw IoError(path, "unknown extension '" + extension +
                            "' of a point file (known: .xyz .txt .csv .pts .asc .ply .obj .off)");
  }
  const FileContent content = read_file(path);
  if (text) return {parse_text_points(content.view(), path), Precision::kDouble};
  if (extension == ".obj") return {parse_obj_points(content.view(), path), Precision::kDouble};
  if (extension == ".off") return {parse_off_points(content.view(), path), Precision::kDouble};
  return parse_ply_points(content.view(), path);
}

}  // namespace tetsculpt
