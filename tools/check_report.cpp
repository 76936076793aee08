#include "tools/check_report.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "tools/json.h"
#include "tools/messages.h"

namespace tetsculpt::cli {
namespace {

/// One kind of fault as it is reported.
struct Line {
  std::string_view key;  ///< in JSON
  std::size_t count;
  std::string text;
};

std::string number(std::size_t n) { return std::to_string(n); }

std::string first_of(const Faults<std::uint32_t>& faults) {
  return (faults.count == 1 ? "; it is number " : "; the first is number ") + number(faults.first);
}

std::string first_of(const Faults<MeshReport::Edge>& faults) {
  return (faults.count == 1 ? "; it joins vertices " : "; the first joins vertices ") +
         number(faults.first[0]) + " and " + number(faults.first[1]);
}

template <class Place>
Line line(std::string_view key, const Faults<Place>& faults, const std::string& noun,
          const std::string& what) {
  return {key, faults.count, counted(faults.count, noun) + ' ' + what + first_of(faults)};
}

/// All kinds, also those of which there is none.
std::vector<Line> fault_lines(const CheckFacts& facts) {
  const MeshReport& r = facts.report;
  const MeshShape none;
  const MeshShape& shape = facts.shape ? *facts.shape : none;
  // With positions, equal corners are flat triangles, too.
  const auto& degenerate = facts.shape ? shape.flat_triangles : r.degenerate;
  std::vector<Line> lines = {
      line("open_edges", r.open_edges, "edge",
           "with one triangle, in " + counted(r.boundary_loops, "loop")),
      line("crowded_edges", r.crowded_edges, "edge", "with more than two triangles"),
      line("misdirected_edges", r.misdirected_edges, "edge",
           "along which triangles run in the same direction"),
      line("torn_vertices", r.torn_vertices, "vertex", "whose triangles are not one cycle or fan"),
      line("degenerate", degenerate, "triangle", "without area"),
      line("duplicate", r.duplicates, "triangle", "with the corners of an earlier one"),
      line("inverted", shape.inverted_shells, "component", "facing into the solid"),
      line("unused", r.unused_points, "vertex", "of no triangle"),
      line("repeated", shape.repeated_points, "vertex",
           "at the position of an earlier one (--weld joins them)"),
      line("invalid", facts.invalid_points, "vertex", "with a NaN or infinite coordinate")};
  if (facts.points) {
    const CheckFacts::Points& p = *facts.points;
    lines.push_back(
        line("missing", p.on_mesh.missing, "point", "of " + p.file + " not among the vertices"));
    lines.push_back(
        line("invented", p.on_mesh.invented, "vertex", "not among the points of " + p.file));
  }
  return lines;
}

/// Summed; none unless each component has one.
std::optional<std::size_t> genus(const MeshReport& report) {
  std::size_t sum = 0;
  for (const Shell& shell : report.shells) {
    if (!shell.genus()) return std::nullopt;
    sum += *shell.genus();
  }
  return sum;
}

std::string yes_or_no(bool yes) { return yes ? "yes\n" : "NO\n"; }

bool outward(const CheckFacts& facts) {
  if (!facts.shape) return false;
  for (const ShellShape& shell : facts.shape->shells) {
    if (!shell.outward) return false;
  }
  return !facts.shape->shells.empty();
}

std::string shell_text(const CheckFacts& facts, std::size_t i) {
  const Shell& shell = facts.report.shells[i];
  std::string text = "  component " + number(i) + ": " + counted(shell.triangles, "triangle") +
                     ", " + counted(shell.vertices, "vertex");
  if (shell.boundary_loops > 0) text += ", " + counted(shell.boundary_loops, "boundary loop");
  if (const auto genus = shell.genus()) text += ", genus " + number(*genus);
  if (facts.shape && shell.closed_manifold() && shell.oriented) {
    const ShellShape& shape = facts.shape->shells[i];
    text += ", volume " + json_number(shape.volume);
    if (shape.depth % 2 == 1) text += ", a cavity";
  }
  return text + '\n';
}

std::string points_text(const CheckFacts::Points& points) {
  std::string text = "points        " + number(points.on_mesh.distinct) + " distinct of " +
                     number(points.given) + " in " + points.file;
  if (points.invalid.count > 0)
    text += ", " + counted(points.invalid.count, "invalid one") + " left out";
  if (points.as_floats) text += ", compared as 32-bit floats";
  return text + '\n';
}

std::string optional_number(std::optional<std::size_t> n) { return n ? number(*n) : "null"; }

JsonObject shell_json(const CheckFacts& facts, std::size_t i) {
  const Shell& shell = facts.report.shells[i];
  JsonObject json;
  json.add("vertices", shell.vertices);
  json.add("edges", shell.edges);
  json.add("triangles", shell.triangles);
  json.add("boundary_loops", shell.boundary_loops);
  json.add("manifold", shell.manifold);
  json.add("oriented", shell.oriented);
  json.add_raw("genus", optional_number(shell.genus()));
  const bool has_volume = facts.shape && shell.closed_manifold() && shell.oriented;
  json.add_raw("volume", has_volume ? json_number(facts.shape->shells[i].volume) : "null");
  json.add_raw("depth", has_volume ? number(facts.shape->shells[i].depth) : "null");
  return json;
}

}  // namespace

bool flawless(const CheckFacts& facts) {
  for (const Line& line : fault_lines(facts)) {
    if (line.count > 0) return false;
  }
  return facts.report.closed();
}

std::string check_text(const CheckFacts& facts) {
  constexpr std::size_t kShellsTold = 20;
  const MeshReport& r = facts.report;
  std::string text = facts.file + ": " + counted(r.triangles, "triangle") + ", " +
                     counted(r.edges, "edge") + ", " + counted(r.vertices, "vertex");
  if (facts.welded > 0) text += " (" + number(facts.welded) + " joined to others)";
  text += "\nclosed        " + yes_or_no(r.closed());
  text += "manifold      " + yes_or_no(r.crowded_edges.count + r.torn_vertices.count == 0);
  text += "oriented      " + yes_or_no(r.misdirected_edges.count == 0);
  text += "outward       " + (facts.shape ? yes_or_no(outward(facts)) : "unknown\n");
  text += "components    " + number(r.shells.size());
  if (const auto sum = genus(r))
    text += ", genus " + number(*sum) + (r.shells.size() > 1 ? " in sum" : "");
  text += '\n';
  for (std::size_t i = 0; i < std::min(r.shells.size(), kShellsTold); ++i) {
    text += shell_text(facts, i);
  }
  if (r.shells.size() > kShellsTold) {
    text += "  and " + number(r.shells.size() - kShellsTold) + " more (--json tells all)\n";
  }
  if (facts.points) text += points_text(*facts.points);
  for (const Line& line : fault_lines(facts)) {
    if (line.count > 0) text += "fault         " + line.text + '\n';
  }
  if (r.edges == 0) text += "fault         no triangles\n";
  return text + (flawless(facts) ? "no faults\n" : "vertices, triangles and points count from 0\n");
}

std::string check_json(const CheckFacts& facts) {
  const MeshReport& r = facts.report;
  JsonObject json;
  json.add("file", facts.file);
  json.add("flawless", flawless(facts));
  json.add("vertices", r.vertices);
  json.add("edges", r.edges);
  json.add("triangles", r.triangles);
  json.add("closed", r.closed());
  json.add("edge_manifold", r.crowded_edges.count == 0);
  json.add("vertex_manifold", r.torn_vertices.count == 0);
  json.add("oriented", r.misdirected_edges.count == 0);
  json.add_raw("outward", !facts.shape ? "null" : outward(facts) ? "true" : "false");
  json.add("components", r.shells.size());
  json.add_raw("genus", optional_number(genus(r)));
  json.add_raw("volume", facts.shape ? json_number(facts.shape->volume) : "null");
  json.add("boundary_loops", r.boundary_loops);
  json.add("welded", facts.welded);
  JsonObject faults;
  for (const Line& line : fault_lines(facts)) faults.add(line.key, line.count);
  json.add("faults", faults);
  if (facts.points) {
    JsonObject points;
    points.add("file", facts.points->file);
    points.add("given", facts.points->given);
    points.add("invalid", facts.points->invalid.count);
    points.add("distinct", facts.points->on_mesh.distinct);
    points.add("as_floats", facts.points->as_floats);
    json.add("points", points);
  }
  JsonArray shells;
  for (std::size_t i = 0; i < r.shells.size(); ++i) shells.add_raw(shell_json(facts, i).text());
  json.add_raw("shells", shells.text());
  return json.text();
}

}  // namespace tetsculpt::cli
