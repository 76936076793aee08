#include "io/content_format.h"

#include <algorithm>
#include <filesystem>

#include "io/stl_reader.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kHead = 4096;  // bytes looked at for lines

std::string_view first_line(std::string_view content) {
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
  return content.substr(0, content.substr(0, kHead).find_first_of("\r\n"));
}

// The keyword with its prefixes, and nothing or a count behind it.
bool begins_as_off(std::string_view content) {
  std::string_view line = first_line(content);
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (line.starts_with(prefix)) line.remove_prefix(prefix.size());
  }
  if (!line.starts_with("OFF")) return false;
  line.remove_prefix(3);
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  return line.empty() || line.front() == '#' || (line.front() >= '0' && line.front() <= '9') ||
         line.starts_with("BINARY");
}

bool begins_with_numbers(TextScanner line) {
  for (int i = 0; i < 3; ++i) {
    if (!line.at_number()) return false;
    line.token();
    line.next_cell();
  }
  return true;
}

struct Unreadable {
  std::string_view begin;
  std::string_view what;
};

constexpr Unreadable kUnreadable[] = {
    {"\x1F\x8B"sv, "compressed with gzip: unzip it first, for example with gunzip"},
    {"PK\x03\x04"sv, "a zip archive: unpack it first, for example with unzip"},
    {"BZh"sv, "compressed with bzip2: unzip it first, for example with bunzip2"},
    {"\xFD"
     "7zXZ\0"sv,
     "compressed with xz: unzip it first, for example with unxz"},
    {"\x28\xB5\x2F\xFD"sv, "compressed with zstd: unzip it first, for example with unzstd"},
    {"7z\xBC\xAF\x27\x1C"sv, "a 7z archive: unpack it first, for example with 7z x"},
    {"\xFF\xFE"sv, "text in UTF-16: save it as UTF-8 first, for example with iconv"},
    {"\xFE\xFF"sv, "text in UTF-16: save it as UTF-8 first, for example with iconv"},
    {"\x89PNG\r\n"sv, "a picture (PNG), not points"},
    {"\xFF\xD8\xFF"sv, "a picture (JPEG), not points"},
    {"%PDF-"sv, "a PDF document, not points"},
    {"glTF"sv, "a binary glTF file, of which no points are read: export it as PLY"},
    {"ASTM-E57"sv, "an E57 file, which is not read: export it as PLY or LAS"},
    {"<?xml"sv, "an XML file, which is not read: export it as PLY"},
    {"<VTKFile"sv, "a VTK XML file, which is not read: export it as PLY or legacy VTK"},
    {"<!DOCTYPE"sv, "a web page, not points"},
    {"<html"sv, "a web page, not points"},
};

}  // namespace

std::optional<PointFormat> marked_format(std::string_view content) {
  const std::string_view line = first_line(content);
  if (line == "ply") return PointFormat::kPly;
  if (content.starts_with("LASF")) return PointFormat::kLas;
  if (line.starts_with("# .PCD")) return PointFormat::kPcd;
  if (line.starts_with("# vtk DataFile Version")) return PointFormat::kVtk;
  if (begins_as_off(content)) return PointFormat::kOff;
  constexpr std::size_t kEmptyStl = 134;  // without a triangle any few bytes may be meant
  if (begins_as_ascii_stl(content) || (content.size() >= kEmptyStl && is_binary_stl(content))) {
    return PointFormat::kStl;
  }
  return std::nullopt;
}

std::optional<PointFormat> apparent_format(std::string_view content) {
  constexpr TextDialect kDialect = {
      .separators = " \t", .delimiters = ",;", .comments = {"#", "//"}};
  constexpr int kLines = 100;
  const std::filesystem::path no_path;
  TextScanner in(content.substr(0, kHead), no_path, kDialect);
  for (int i = 0; i < kLines && in.next_content_line(); ++i) {
    if (begins_with_numbers(in)) return PointFormat::kText;
    if (in.token() == "v" && begins_with_numbers(in)) return PointFormat::kObj;
  }
  return std::nullopt;
}

std::optional<std::string> known_as_unreadable(std::string_view content) {
  for (const Unreadable& known : kUnreadable) {
    if (content.starts_with(known.begin)) return std::string(known.what);
  }
  return std::nullopt;
}

}  // namespace tetsculpt
