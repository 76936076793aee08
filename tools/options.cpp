#include "tools/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "io/parse_number.h"

namespace tetsculpt::cli {
namespace {

template <class Value>
using Named = std::pair<std::string_view, Value>;

constexpr std::array<Named<Method>, 2> kMethods{
    {{"guided", Method::kGuided}, {"paper", Method::kPaper}}};
constexpr std::array<Named<Criterion>, 4> kCriteria{{{"area", Criterion::kMinimalArea},
                                                     {"gamma", Criterion::kGamma},
                                                     {"longest", Criterion::kLongestEdge},
                                                     {"constrained", Criterion::kConstrained}}};
constexpr std::array<Named<UpAxis>, 3> kAxes{
    {{"x", UpAxis::kX}, {"y", UpAxis::kY}, {"z", UpAxis::kZ}}};

template <class Value, std::size_t N>
std::vector<std::string> names_of(const std::array<Named<Value>, N>& named) {
  std::vector<std::string> names;
  for (const auto& [known, value] : named) names.emplace_back(known);
  return names;
}

/// Precondition: the word is one of the names.
template <class Value, std::size_t N>
Value value_of(std::string_view word, const std::array<Named<Value>, N>& named) {
  return std::ranges::find(named, word, &Named<Value>::first)->second;
}

template <class Value, std::size_t N>
std::string name_of(Value value, const std::array<Named<Value>, N>& named) {
  return std::string(std::ranges::find(named, value, &Named<Value>::second)->first);
}

/// Names of formats from a list of extensions: ".ply .obj".
std::vector<std::string> format_names(const std::string& extensions) {
  std::vector<std::string> names = split_words(extensions);
  for (std::string& name : names) name.erase(0, 1);
  return names;
}

void note_file(std::filesystem::path& file, std::string_view option, std::string_view value) {
  if (value.empty()) throw UsageError(std::string(option) + " needs a file");
  if (!file.empty()) throw UsageError(std::string(option) + " is given twice");
  file = value;
}

int threads_of(std::string_view word) {
  int threads = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), threads);
  if (error != std::errc() || end != word.data() + word.size() || threads < 1 || threads > 1024) {
    throw UsageError("--threads: '" + std::string(word) + "' is not a number from 1 to 1024");
  }
  return threads;
}

/// Sets the two angles of `view`.
void note_angles(std::string_view word, View& view) {
  const std::size_t comma = word.find(',');
  const auto number = [](std::string_view text) {
    const ParsedNumber<double> parsed = parse_number<double>(text);
    const bool whole =
        parsed.fault == NumberFault::kNone && parsed.end == text.data() + text.size();
    return whole && std::isfinite(parsed.value) ? std::optional(parsed.value) : std::nullopt;
  };
  const auto azimuth = number(word.substr(0, comma));
  const auto elevation =
      comma == std::string_view::npos ? std::nullopt : number(word.substr(comma + 1));
  if (!azimuth || !elevation || std::abs(*elevation) > 90) {
    throw UsageError("--view: '" + std::string(word) +
                     "' is not AZIMUTH,ELEVATION in degrees, the elevation from -90 to 90");
  }
  view.azimuth = *azimuth;
  view.elevation = *elevation;
}

using Words = std::string_view;
using enum OptionGroup;
using enum Takes;

constexpr Option kOptions[] = {
    {kInput, 'i', "input", kValue, "FILE", "read the points from FILE; - is standard input",
     [](Arguments& a, Words value) { note_file(a.input, "--input", value); }},
    {kInput, 0, "input-format", kValue, "NAME",
     "the format of the points, whatever the file is called: one of the extensions above, without "
     "its dot. Standard input needs it unless the content tells",
     [](Arguments& a, Words value) { a.input_format = point_format_named(value); },
     [] { return format_names(point_format_extensions()); }},
    {kInput, 0, "skip-invalid", kNothing, "",
     "drop points with a NaN or infinite coordinate and say how many; without this they are an "
     "error",
     [](Arguments& a, Words) { a.skip_invalid = true; }},
    {kInput, 'n', "dry-run", kNothing, "",
     "read and check the points, say how many there are and where (as tetsculpt info does, but "
     "for the spacing), and stop: needs no SURFACE, writes nothing",
     [](Arguments& a, Words) { a.dry_run = true; }},

    {kOutput, 'o', "output", kValue, "FILE", "write the surface to FILE; - is standard output",
     [](Arguments& a, Words value) { note_file(a.output, "--output", value); }},
    {kOutput, 0, "output-format", kValue, "NAME",
     "the format of the surface, whatever the file is called: one of the extensions above, "
     "without its dot. Standard output needs it",
     [](Arguments& a, Words value) { a.output_format = mesh_format_named(value); },
     [] { return format_names(mesh_format_extensions()); }},
    {kOutput, 0, "ascii", kNothing, "", "write a .ply file as text",
     [](Arguments& a, Words) { a.ply_encoding = PlyEncoding::kAscii; }},
    {kOutput, 0, "normals", kNothing, "",
     "write the normals of the surface at its vertices, too, in the place of the input's",
     [](Arguments& a, Words) { a.normals = true; }},
    {kOutput, 0, "no-attributes", kNothing, "",
     "write positions only; without this the points' colours, normals and other attributes go "
     "along where the format can hold them",
     [](Arguments& a, Words) { a.attributes = false; }},

    {kMethod, 0, "method", kValue, "NAME",
     "how to sculpt: guided by evidence for inside and outside (the default), or paper (Attene, "
     "Spagnuolo 2000)",
     [](Arguments& a, Words value) { a.options.method = value_of(value, kMethods); },
     [] { return names_of(kMethods); }},
    {kMethod, 0, "criterion", kValue, "NAME",
     "with --method paper, which tetrahedron goes first: constrained (the paper's own, the "
     "default), longest, area, gamma",
     [](Arguments& a, Words value) { a.options.criterion = value_of(value, kCriteria); },
     [] { return names_of(kCriteria); }},
    {kMethod, 0, "threads", kValue, "N",
     "use at most N threads (default: all cores); the surface does not depend on it",
     [](Arguments& a, Words value) { a.options.threads = threads_of(value); }},

    {kMore, 0, "picture", kValue, "FILE",
     "draw the surface into a .png file; what is seen of it from inside is red",
     [](Arguments& a, Words value) {
       a.picture.clear(), note_file(a.picture, "--picture", value);
     }},
    {kMore, 0, "viewer", kValue, "FILE",
     "write a page that shows the surface in any browser: to be turned, with points, graphs and "
     "the "
     "steps that led to it (.html, one file, needs no network)",
     [](Arguments& a, Words value) { a.viewer.clear(), note_file(a.viewer, "--viewer", value); }},
    {kMore, 0, "view", kValue, "AZ,EL",
     "from where, in degrees: AZ around the upright axis, EL above (default: 30,20)",
     [](Arguments& a, Words value) { note_angles(value, a.view), a.view_given = true; }},
    {kMore, 0, "up", kValue, "AXIS",
     "which axis is upright in picture and viewer: x, y, z (the default)",
     [](Arguments& a, Words value) { a.view.up = value_of(value, kAxes), a.view_given = true; },
     [] { return names_of(kAxes); }},
    {kMore, 0, "graphs", kValue, "PREFIX",
     "write the graphs behind the surface, too: PREFIX_emst.ply (Euclidean minimum spanning "
     "tree), PREFIX_gabriel.ply (Gabriel graph), PREFIX_egh.ply (extended Gabriel hypergraph, "
     "with its triangles), with vertices in the order of the surface's",
     [](Arguments& a, Words value) { a.graphs.clear(), note_file(a.graphs, "--graphs", value); }},
    {kMore, 0, "tetrahedra", kValue, "FILE",
     "write the Delaunay tetrahedra and which of them are inside, too: .vtk or .mesh",
     [](Arguments& a, Words value) {
       a.tetrahedra.clear(), note_file(a.tetrahedra, "--tetrahedra", value);
     }},

    {kReport, 0, "stats", kOptionalValue, "FILE",
     "write what was computed as one JSON object to FILE, or print it on stdout; its members are "
     "in the manual",
     [](Arguments& a, Words value) {
       a.stats = true;
       a.stats_file = value == "-" ? "" : value;
     }},
    {kReport, 'q', "quiet", kNothing, "", "no progress and no summary",
     [](Arguments& a, Words) { a.quiet = true; }},
    {kReport, 'v', "verbose", kNothing, "", "say what each stage did and how long it took",
     [](Arguments& a, Words) { a.verbose = true; }},
    {kReport, 0, "progress", kNothing, "",
     "show progress from the start; without this it is shown if the work takes over a second",
     [](Arguments& a, Words) { a.progress = true; }},

    {kProgram, 'h', "help", kNothing, "", "this text",
     [](Arguments& a, Words) { a.action = Action::kHelp; }},
    {kProgram, 0, "version", kNothing, "", "the version",
     [](Arguments& a, Words) { a.action = Action::kVersion; }},
    {kHidden, 0, "print-manual", kNothing, "", "the manual page, for the build",
     [](Arguments& a, Words) { a.action = Action::kManual; }},
    {kHidden, 0, "print-completion", kNothing, "", "the completion for bash, for the build",
     [](Arguments& a, Words) { a.action = Action::kCompletion; }},
};

}  // namespace

std::span<const Option> options() { return kOptions; }

std::string name(Method method) { return name_of(method, kMethods); }
std::string name(Criterion criterion) { return name_of(criterion, kCriteria); }

std::vector<std::string> split_words(std::string_view list) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(' ', at), list.size());
    words.emplace_back(list.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

}  // namespace tetsculpt::cli
