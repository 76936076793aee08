#include "tools/report.h"

#include "tools/console.h"
#include "tools/json.h"

namespace tetsculpt::cli {
namespace {

bool manifold(const Topology& t) { return t.edge_manifold && t.vertex_manifold; }

std::size_t merged(const Reconstruction& result, const RunFacts& facts) {
  return facts.points - facts.skipped - result.counts.vertices;
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
