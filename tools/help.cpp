#include "tools/help.h"

#include <cstddef>
#include <string_view>

#include "io/mesh_format.h"
#include "io/point_format.h"
#include "tools/messages.h"
#include "tools/options.h"

namespace tetsculpt::cli {
namespace {

constexpr std::size_t kColumns = 80;
constexpr std::size_t kHelpColumn = 23;

/// Appends `label` and, from `column` on, the words of `text` in lines that end before kColumns.
void append_entry(std::string& out, std::string label, std::string_view text, std::size_t column) {
  if (label.size() + 2 > column) {
    out += label + '\n';
    label.clear();
  }
  std::string line = label + std::string(column - label.size(), ' ');
  bool empty = true;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(word.size() == text.size() ? word.size() : word.size() + 1);
    if (!empty && line.size() + 1 + word.size() >= kColumns) {
      out += line + '\n';
      line.assign(column, ' ');
      empty = true;
    }
    if (!empty) line += ' ';
    line += word;
    empty = false;
  }
  out += line + '\n';
}

std::string label_of(const Option& option) {
  std::string label = option.letter != 0 ? std::string("  -") + option.letter + ", " : "      ";
  label.append("--").append(option.name);
  if (option.takes == Takes::kValue) label.append(" ").append(option.value);
  if (option.takes == Takes::kOptionalValue) label.append("[=").append(option.value).append("]");
  return label;
}

void append_options(std::string& out) {
  for (const auto& [group, title] : kGroupTitles) {
    out.append("\n").append(title).append(":\n");
    for (const Option& option : options()) {
      if (option.group == group) append_entry(out, label_of(option), option.help, kHelpColumn);
    }
  }
}

constexpr std::string_view kBeginning =
    R"(Usage: tetsculpt [OPTIONS] POINTS SURFACE
       tetsculpt check MESH
       tetsculpt info POINTS

Turns points in space, as a scanner gives them, into a surface: a closed mesh
of triangles whose corners are exactly these points. It needs their positions
only: no normals, no order, no parameter. To begin with, try

  tetsculpt scan.xyz surface.ply

)";

constexpr std::string_view kExamples = R"(
Examples:
  Is the file understood? How many points, and where?
    tetsculpt --dry-run scan.xyz
  A surface, and a picture of it with the y axis upright:
    tetsculpt --picture kitten.png --up y kitten.xyz kitten.ply
  Numbers for a program:
    tetsculpt --stats slices.csv organ.stl > organ.json
  In a pipe:
    zcat scan.xyz.gz | tetsculpt --input-format xyz - surface.ply
  The tetrahedra and the graphs behind the surface:
    tetsculpt --tetrahedra all.vtk --graphs scan scan.xyz surface.ply

Exit status:
)";

}  // namespace

std::string help() {
  constexpr std::size_t kWordColumn = 12;
  std::string out(kBeginning);
  append_entry(out, "  POINTS",
               point_format_extensions() +
                   "; text has x y z per line, with any separator. - is standard input",
               kWordColumn);
  append_entry(out, "  SURFACE", mesh_format_extensions() + "; - is standard output", kWordColumn);
  append_entry(out, "  MESH", "a surface to be judged: is it closed, manifold, of which genus?",
               kWordColumn);
  append_options(out);
  out += kExamples;
  for (const auto& [status, meaning] : status_meanings()) {
    append_entry(out, "  " + std::to_string(status), meaning, 7);
  }
  return out;
}

}  // namespace tetsculpt::cli
