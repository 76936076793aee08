#include "tools/info.h"

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/io_error.h"
#include "io/read_points.h"
#include "kernel/distinct_points.h"
#include "tools/arguments.h"
#include "tools/file_words.h"
#include "tools/messages.h"
#include "tools/point_facts.h"

namespace tetsculpt::cli {
namespace {

std::string info_help() {
  return R"(Usage: tetsculpt info [OPTIONS] POINTS

Describes a file of points: how many, what they span and how densely they lie,
and what else the file says of each.

  POINTS    )" +
         point_format_extensions() + R"(

Options:
  --json        print one JSON object (--stats means the same)
  -h, --help    this text

Exit status:
  0  done
  1  wrong usage
  2  the file is unreadable or broken, or its coordinates are too far apart
  5  standard output could not be written
)";
}

PointFacts describe(const std::filesystem::path& path) {
  PointFile file = read_points(path);
  const std::size_t invalid =
      std::erase_if(file.points, [](const Point3& p) { return !finite(p); });
  return point_facts(file, path, invalid, Spacing::kMeasured);
}

}  // namespace

int info(std::span<const char* const> words) {
  FileWords parsed;
  PointFacts facts;
  try {
    parsed = parse_file_words(words, {.noun = "point"});
    if (parsed.help) return print(info_help());
    facts = describe(parsed.file);
  } catch (const UsageError& error) {
    return fail(kUsage, std::string(error.what()) + " ('tetsculpt info --help' explains)");
  } catch (const IoError& error) {
    return fail(kBadInput, error.what());
  } catch (const InvalidPoint& error) {
    return fail(kBadInput, parsed.file.string() + ": " + error.what() +
                               " (points count from 0, without invalid ones)");
  } catch (const std::length_error& error) {
    return fail(kBadInput, parsed.file.string() + ": " + error.what());
  }
  return print(parsed.json ? facts_json(facts) + '\n' : facts_text(facts));
}

}  // namespace tetsculpt::cli
