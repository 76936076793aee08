#include <string>
#include <string_view>

#include "io/mesh_format.h"
#include "io/point_format.h"
#include "io/read_mesh.h"
#include "tools/help.h"
#include "tools/messages.h"
#include "tools/options.h"
#include "tools/report.h"
#include "tools/version.h"

namespace tetsculpt::cli {
namespace {

/// When the text was last gone over.
constexpr std::string_view kWritten = "2026-11-26";

/// Text as troff takes it literally.
std::string literal(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if (c == '\'') {
      out += "\\(cq";
    } else {
      out += c;
    }
  }
  return out.starts_with('.') ? "\\&" + out : out;
}

std::string bold(std::string_view text) { return "\\fB" + literal(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + literal(text) + "\\fR"; }

std::string entry(const std::string& tag, std::string_view text) {
  return ".TP\n" + tag + '\n' + literal(text) + ".\n";
}

std::string option_tag(const Option& option) {
  std::string tag = option.letter != 0 ? bold(std::string("-") + option.letter) + ", " : "";
  tag += bold("--" + std::string(option.name));
  if (option.takes == Takes::kValue) tag += ' ' + italic(option.value);
  if (option.takes == Takes::kOptionalValue) tag += "[=" + italic(option.value) + ']';
  return tag;
}

std::string options_section() {
  std::string text = ".SH OPTIONS\n";
  for (const auto& [group, title] : kGroupTitles) {
    text.append(".SS ").append(title).append("\n");
    for (const Option& option : options()) {
      if (option.group == group) text += entry(option_tag(option), option.help);
    }
  }
  return text;
}

std::string stats_section() {
  std::string text =
      ".SH STATISTICS\nWith\n.B \\-\\-stats\none JSON object is written on one line. Members keep "
      "their names and meanings from version to version; new ones may come.\n";
  for (const auto& [name, type, meaning] : stats_members()) {
    text += entry(bold(name) + " (" + std::string(type) + ")", meaning);
  }
  return text;
}

std::string status_section() {
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& [status, meaning] : status_meanings()) {
    text += entry(bold(std::to_string(status)), meaning);
  }
  return text +
         "Each file appears whole or not at all, whatever the status. By a signal the program ends "
         "at once, by that signal: 130 and 143 are what a shell makes of it.\n";
}

constexpr std::string_view kSynopsis = R"(.SH NAME
tetsculpt \- a closed surface through every point of a set in space
.SH SYNOPSIS
.B tetsculpt
.RI [ OPTIONS ]
.I POINTS SURFACE
.br
.B tetsculpt
.RI [ OPTIONS ]
.B \-i
.I POINTS
.B \-o
.I SURFACE
.br
.B tetsculpt check
.I MESH
.br
.B tetsculpt info
.I POINTS
.SH DESCRIPTION
.B tetsculpt
reads unorganised points in space and writes a closed, oriented, manifold mesh of triangles whose
vertices are exactly these points, of any genus. It needs their positions only: no normals, no order,
no parameter. What it writes depends on the set of points alone.
.PP
Of equal points the first is a vertex; the order of the vertices is that of the file. Numbers are
written so that they read back bit for bit, except in STL and glTF, which hold floats.
.PP
)";

std::string formats() {
  return ".I POINTS\nis a file with one of the extensions " + literal(point_format_extensions()) +
         ", or \\- for standard input. A file of text has x y z on each line, with any separator; "
         "of meshes the vertices are taken.\n.PP\n.I SURFACE\nis a file with one of the "
         "extensions " +
         literal(mesh_format_extensions()) +
         ", or \\- for standard output, which needs\n.BR \\-\\-output\\-format .\n.PP\n"
         ".I MESH\nis a file with one of the extensions " +
         literal(mesh_source_extensions()) +
         ".\n.B tetsculpt check\njudges it;\n.B tetsculpt info\ndescribes points.\n"
         "Options may stand anywhere;\n.B \\-\\-\nends them.\n";
}

constexpr std::string_view kEnd = R"(.SH NOTES
Progress goes to standard error: on a terminal as one line that is written again and again, elsewhere
as lines some seconds apart. Work that takes less than a second shows none without
.BR \-\-progress .
Files that can't be made are found before the work begins.
.SH EXAMPLES
.EX
tetsculpt \-\-dry\-run scan.xyz
tetsculpt scan.xyz surface.ply
tetsculpt \-\-picture kitten.png \-\-up y kitten.xyz kitten.ply
tetsculpt \-\-stats=organ.json slices.csv organ.stl
zcat scan.xyz.gz | tetsculpt \-\-input\-format xyz \- surface.ply
tetsculpt \-\-method paper \-\-graphs scan scan.xyz surface.ply
.EE
.SH REFERENCES
M. Attene, M. Spagnuolo, Automatic surface reconstruction from point sets in space, Computer Graphics
Forum 19(3), 2000.
)";

}  // namespace

std::string manual() {
  std::string text = ".TH TETSCULPT 1 \"" + std::string(kWritten) + "\" \"tetsculpt ";
  text.append(kVersion).append("\" \"User commands\"\n").append(kSynopsis).append(formats());
  return text + options_section() + stats_section() + status_section() + std::string(kEnd);
}

}  // namespace tetsculpt::cli
