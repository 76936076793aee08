#include "tools/report.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "tools/json.h"
#include "tools/messages.h"
#include "tools/options.h"
#include "tools/version.h"

namespace tetsculpt::cli {
namespace {

bool manifold(const Topology& t) { return t.edge_manifold && t.vertex_manifold; }

std::size_t merged(const Reconstruction& result, const RunFacts& facts) {
  return facts.points - facts.skipped - result.counts.vertices;
}

constexpr std::array<StatsMember, 21> kStatsMembers{{
    {"version", "string", "of the program"},
    {"points", "integer", "points read, invalid ones included"},
    {"skipped", "integer", "invalid points dropped by --skip-invalid"},
    {"duplicates", "integer", "points equal to an earlier one, merged with it"},
    {"vertices", "integer", "distinct points"},
    {"tetrahedra", "integer", "of the Delaunay tetrahedralization"},
    {"emst_edges", "integer", "of the Euclidean minimum spanning tree"},
    {"gabriel_edges", "integer", "of the Gabriel graph"},
    {"egh_edges", "integer", "of the extended Gabriel hypergraph"},
    {"egh_triangles", "integer", "likewise"},
    {"triangles", "integer", "of the surface"},
    {"components", "integer", "connected pieces of the surface"},
    {"genus", "integer", "handles, summed over the pieces"},
    {"closed", "boolean", "every edge of the surface has two triangles"},
    {"manifold", "boolean", "around every edge and vertex it is one sheet"},
    {"hidden", "integer", "distinct points that could not be brought to the surface"},
    {"method", "string", "guided or paper"},
    {"criterion", "string", "as given, or constrained"},
    {"threads", "integer", "the most that were used"},
    {"holes", "integer", "pseudo-prisms removed (--method paper)"},
    {"seconds", "object",
     "wall-clock seconds, numbers: read, delaunay, graphs, sculpt, write, total"},
}};

std::string in_seconds(double seconds) {
  char digits[32];
  const auto end =
      std::to_chars(digits, digits + sizeof digits, seconds, std::chars_format::fixed, 3);
  return " (" + std::string(digits, end.ptr) + " s)";
}

std::string shown(const std::filesystem::path& file, std::string_view stream) {
  return file == "-" ? std::string(stream) : file.string();
}

}  // namespace

std::span<const StatsMember> stats_members() { return kStatsMembers; }

std::string stage_lines(const Arguments& arguments, const Reconstruction& result,
                        const RunFacts& facts) {
  const auto& counts = result.counts;
  std::string lines;
  const auto add = [&](std::string_view stage, const std::string& what, double seconds) {
    lines.append("tetsculpt: ").append(stage).append(": ").append(what);
    lines += in_seconds(seconds) + '\n';
  };
  add("read", counted(facts.points, "point") + " from " + shown(arguments.input, "standard input"),
      facts.seconds_read);
  add("delaunay",
      counted(counts.vertices, "distinct point") + ", " + counted(counts.tetrahedra, "tetrahedron"),
      result.seconds.delaunay);
  add("graphs",
      counted(counts.gabriel_edges, "Gabriel edge") + "; EGH with " +
          counted(counts.egh_edges, "edge") + " and " + counted(counts.egh_triangles, "triangle"),
      result.seconds.graphs);
  add("sculpt",
      counted(result.mesh.triangles.size(), "triangle") + " by the " +
          name(arguments.options.method) + " method",
      result.seconds.sculpt);
  add("write", shown(arguments.output, "standard output"), facts.seconds_write);
  add("all", counted(static_cast<std::size_t>(arguments.options.threads), "thread") + " at most",
      facts.seconds_total);
  return lines;
}

std::string stats_json(const Arguments& arguments, const Reconstruction& result,
                       const RunFacts& facts) {
  JsonObject seconds;
  seconds.add("read", facts.seconds_read);
  seconds.add("delaunay", result.seconds.delaunay);
  seconds.add("graphs", result.seconds.graphs);
  seconds.add("sculpt", result.seconds.sculpt);
  seconds.add("write", facts.seconds_write);
  seconds.add("total", facts.seconds_total);
  JsonObject stats;
  stats.add("version", std::string(kVersion));
  stats.add("points", facts.points);
  stats.add("skipped", facts.skipped);
  stats.add("duplicates", merged(result, facts));
  stats.add("vertices", result.counts.vertices);
  stats.add("tetrahedra", result.counts.tetrahedra);
  stats.add("emst_edges", result.counts.emst_edges);
  stats.add("gabriel_edges", result.counts.gabriel_edges);
  stats.add("egh_edges", result.counts.egh_edges);
  stats.add("egh_triangles", result.counts.egh_triangles);
  stats.add("triangles", result.mesh.triangles.size());
  stats.add("components", facts.topology.components);
  stats.add("genus", facts.topology.genus);
  stats.add("closed", facts.topology.closed);
  stats.add("manifold", manifold(facts.topology));
  stats.add("hidden", result.hidden.size());
  stats.add("method", name(arguments.options.method));
  stats.add("criterion", name(arguments.options.criterion));
  stats.add("threads", static_cast<std::size_t>(arguments.options.threads));
  stats.add("holes", result.counts.holes);
  stats.add("seconds", seconds);
  return stats.text();
}

std::string summary(const Arguments& arguments, const Reconstruction& result,
                    const RunFacts& facts) {
  const Topology& t = facts.topology;
  std::string line = shown(arguments.output, "standard output") + ": " +
                     counted(result.mesh.triangles.size(), "triangle") + " through " +
                     counted(result.mesh.points.size(), "point");
  if (merged(result, facts) > 0)
    line += ", " + counted(merged(result, facts), "duplicate") + " merged";
  if (facts.skipped > 0) line += ", " + counted(facts.skipped, "invalid point") + " skipped";
  line += t.closed ? "; closed" : "; not closed";
  line += manifold(t) ? ", manifold" : ", not manifold";
  line += ", genus " + std::to_string(t.genus) + ", " + counted(t.components, "component");
  return line;
}

}  // namespace tetsculpt::cli
