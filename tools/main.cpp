// The command line program: parses, calls the library, reports. Exit statuses are in help().
#include <chrono>
#include <cstdio>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/io_error.h"
#include "io/picture.h"
#include "io/png_writer.h"
#include "io/read_points.h"
#include "io/write_mesh.h"
#include "sculpt/reconstruct.h"
#include "tools/arguments.h"
#include "tools/check.h"
#include "tools/console.h"
#include "tools/info.h"
#include "tools/progress.h"
#include "tools/report.h"
#include "tools/version.h"

namespace tetsculpt::cli {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string no_solid(const Reconstruction& result, const Arguments& arguments) {
  const std::string file = arguments.input.string() + ": ";
  const std::string distinct = std::to_string(result.counts.vertices) + " distinct points";
  switch (result.span) {
    case Span::kNothing:
      return file + "no points; a solid needs at least 4";
    case Span::kPoint:
      return file + "only one distinct point; a solid needs at least 4";
    case Span::kLine:
      return file + distinct + ", all on one line: they span no solid";
    default:
      return file + distinct + ", all in one plane: they span no solid";
  }
}

/// Names the input points (counted from 0, skipped ones included) that are not on the surface.
void report_hidden(const std::vector<std::size_t>& hidden,
                   const std::vector<std::size_t>& index_in_file) {
  std::fprintf(stderr,
               "tetsculpt: not on the surface, %zu in sum, points counted from 0:", hidden.size());
  for (const std::size_t i : hidden) std::fprintf(stderr, " %zu", index_in_file[i]);
  std::fprintf(stderr, "\n");
}

/// Throws IoError.
void write_outputs(const Arguments& arguments, const TriangleMesh& mesh, Precision precision) {
  write_mesh(mesh, arguments.output, {.precision = precision});
  if (arguments.picture.empty()) return;
  write_png(draw({.mesh = &mesh}, arguments.view), arguments.picture);
}

int run(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  RunFacts facts;
  PointFile file;
  try {
    file = read_points(arguments.input);
  } catch (const IoError& error) {
    return fail(kBadInput, error.what());
  }
  facts.points = file.points.size();
  std::vector<std::size_t> index_in_file;
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    if (arguments.skip_invalid && !finite(file.points[i])) continue;
    file.points[index_in_file.size()] = file.points[i];
    index_in_file.push_back(i);
  }
  facts.skipped = facts.points - index_in_file.size();
  file.points.resize(index_in_file.size());
  facts.seconds_read = seconds_since(start);

  ReconstructOptions options = arguments.options;
  if (!arguments.quiet) options.progress = Progress();
  Reconstruction result;
  try {
    result = reconstruct(file.points, options);
  } catch (const InvalidPoint& error) {
    return fail(kBadInput,
                arguments.input.string() + ": " + error.what() + " (points count from 0" +
                    (finite(file.points[error.index()]) ? ")" : "; --skip-invalid drops it)"));
  } catch (const std::length_error& error) {
    return fail(kBadInput, arguments.input.string() + ": " + error.what());
  }
  if (result.span != Span::kSolid) return fail(kNoSolid, no_solid(result, arguments));
  facts.topology = topology(result.mesh);

  const auto write_start = std::chrono::steady_clock::now();
  try {
    write_outputs(arguments, result.mesh, file.precision);
  } catch (const IoError& error) {
    return fail(kNoOutput, error.what());
  }
  facts.seconds_write = seconds_since(write_start);
  facts.seconds_total = seconds_since(start);

  if (!arguments.quiet) std::fprintf(stderr, "%s\n", summary(arguments, result, facts).c_str());
  if (arguments.stats && print(stats_json(arguments, result, facts) + '\n') != kDone) {
    return kNoOutput;
  }
  if (result.hidden.empty()) return kDone;
  report_hidden(result.hidden, index_in_file);
  return kHidden;
}

int run_words(std::span<const char* const> words) {
  const std::string_view first = words.empty() ? "" : words.front();
  if (first == "check") return check(words.subspan(1));
  if (first == "info") return info(words.subspan(1));
  Arguments arguments;
  try {
    arguments = parse_arguments(words);
  } catch (const UsageError& error) {
    return fail(kUsage, std::string(error.what()) + " ('tetsculpt --help' explains)");
  }
  switch (arguments.action) {
    case Action::kHelp:
      return print(help());
    case Action::kVersion:
      return print(std::string("tetsculpt ") + kVersion + '\n');
    case Action::kReconstruct:
      break;
  }
  return run(arguments);
}

}  // namespace
}  // namespace tetsculpt::cli

int main(int argc, char** argv) {
  try {
    return tetsculpt::cli::run_words({argv + 1, static_cast<std::size_t>(argc - 1)});
  } catch (const std::bad_alloc&) {
    return tetsculpt::cli::fail(tetsculpt::cli::kBadInput, "out of memory for this many points");
  }
}
