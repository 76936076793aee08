#include "tools/check.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/io_error.h"
#include "io/read_mesh.h"
#include "io/read_points.h"
#include "kernel/distinct_points.h"
#include "kernel/welded.h"
#include "tools/arguments.h"
#include "tools/check_report.h"
#include "tools/file_words.h"
#include "tools/messages.h"

namespace tetsculpt::cli {
namespace {

std::string check_help() {
  return R"(Usage: tetsculpt check [OPTIONS] MESH

Judges the triangles of any mesh file: whether they are a closed manifold,
oriented and facing outward (cavities: into the cavity), in how many pieces and
of what genus, and what is wrong. All but the volumes is exact. Polygons are cut
into fans. Triangles that cross each other are not looked for.
Corners of STL files, and of glTF without indices, are one vertex where their
positions are equal. Other files say themselves which vertices are shared; those
that were split for their normals or texture leave open edges without --weld.

  MESH    )" +
         mesh_source_extensions() +
         R"(

Options:
  --points FILE   also: every distinct point of FILE is a vertex, and no vertex
                  is anything else, bit for bit; as 32-bit floats if those of
                  MESH are
  --weld          first join vertices of one position
  --json          print one JSON object (--stats means the same)
  -h, --help      this text

Exit status:
  0  a closed, oriented, outward manifold without faults
  1  wrong usage
  2  a file is unreadable or broken, or its coordinates are too far apart
  5  standard output could not be written
  6  the mesh has faults
)";
}

/// Rounds all coordinates to floats. In two loops, for g++ 12.2 makes nothing of a conversion to
/// float and back where it takes two coordinates at once.
void round_to_floats(std::vector<Point3>& points) {
  std::vector<std::array<float, 3>> rounded;
  rounded.reserve(points.size());
  for (const Point3& p : points) {
    rounded.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [x, y, z] = rounded[i];
    points[i] = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
}

CheckFacts::Points judge_points(const FileWords& words, const MeshFile& file,
                                const MeshReport& report) {
  PointFile input = read_points(words.points);
  CheckFacts::Points facts{.file = words.points.string(),
                           .given = input.points.size(),
                           .invalid = invalid_points(input.points),
                           .as_floats = file.precision == Precision::kSingle,
                           .on_mesh = {}};
  std::erase_if(input.points, [](const Point3& p) { return !finite(p); });
  if (facts.as_floats) round_to_floats(input.points);
  facts.on_mesh = compare_points(file.mesh, report, input.points);
  return facts;
}

CheckFacts judge_file(const FileWords& words) {
  MeshFile file = read_mesh(words.file);
  CheckFacts facts{
      .file = words.file.string(), .report = {}, .invalid_points = {}, .shape = {}, .points = {}};
  if (words.weld) {
    const std::size_t before = file.mesh.points.size();
    file.mesh = welded(std::move(file.mesh));
    facts.welded = before - file.mesh.points.size();
  }
  facts.report = judge(file.mesh);
  facts.invalid_points = invalid_points(file.mesh.points);
  if (facts.invalid_points.count == 0) facts.shape = measure(file.mesh, facts.report);
  if (!words.points.empty()) facts.points = judge_points(words, file, facts.report);
  return facts;
}

}  // namespace

int check(std::span<const char* const> words) {
  FileWords parsed;
  CheckFacts facts;
  try {
    parsed = parse_file_words(words, {.noun = "mesh", .mesh_options = true});
    if (parsed.help) return print(check_help());
    facts = judge_file(parsed);
  } catch (const UsageError& error) {
    return fail(kUsage, std::string(error.what()) + " ('tetsculpt check --help' explains)");
  } catch (const IoError& error) {
    return fail(kBadInput, error.what());
  } catch (const InvalidPoint& error) {
    return fail(kBadInput, parsed.file.string() + ": " + error.what() + " (vertices count from 0)");
  } catch (const std::length_error& error) {
    return fail(kBadInput, parsed.file.string() + ": " + error.what());
  }
  if (print(parsed.json ? check_json(facts) + '\n' : check_text(facts)) != kDone) return kNoOutput;
  return flawless(facts) ? kDone : kFaulty;
}

}  // namespace tetsculpt::cli
