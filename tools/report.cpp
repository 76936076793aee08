#include "tools/report.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace tetsculpt::cli {
namespace {

/// Writes the members of one JSON object in the order they are added.
class JsonObject {
 public:
  void add(std::string_view key, std::size_t value) { add_raw(key, std::to_string(value)); }
  void add(std::string_view key, bool value) { add_raw(key, value ? "true" : "false"); }
  void add(std::string_view key, const std::string& value) { add_raw(key, '"' + value + '"'); }
  void add(std::string_view key, double seconds) {
    char digits[32];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, seconds, std::chars_format::fixed, 6);
    add_raw(key, std::string_view(digits, end.ptr));
  }
  void add(std::string_view key, const JsonObject& object) { add_raw(key, object.text()); }
  std::string text() const { return '{' + members_ + '}'; }

 private:
  void add_raw(std::string_view key, std::string_view value) {
    if (!members_.empty()) members_ += ", ";
    members_.append("\"").append(key).append("\": ").append(value);
  }
  std::string members_;
};

bool manifold(const Topology& t) { return t.edge_manifold && t.vertex_manifold; }

std::size_t merged(const Reconstruction& result, const RunFacts& facts) {
  return facts.points - facts.skipped - result.counts.vertices;
}

std::string counted(std::size_t n, std::string_view noun) {
  return std::to_string(n) + ' ' + std::string(noun) + (n == 1 ? "" : "s");
}

}  // namespace

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
  stats.add("seconds", seconds);
  return stats.text();
}

std::string summary(const Arguments& arguments, const Reconstruction& result,
                    const RunFacts& facts) {
  const Topology& t = facts.topology;
  std::string line = arguments.output.string() + ": " +
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
