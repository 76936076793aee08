#include "tools/run.h"

#include <chrono>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/file_content.h"
#include "io/io_error.h"
#include "io/read_points.h"
#include "tools/messages.h"
#include "tools/outputs.h"
#include "tools/point_facts.h"
#include "tools/progress.h"
#include "tools/report.h"

namespace tetsculpt::cli {
namespace {

class Clock {
 public:
  /// Since it was made.
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string input_name(const Arguments& arguments) {
  return arguments.reads_standard_input() ? "standard input" : arguments.input.string();
}

PointFile read_file_of(const Arguments& arguments) {
  const ReadPointsOptions options{.format = arguments.input_format};
  if (!arguments.reads_standard_input()) return read_points(arguments.input, options);
  return parse_points(read_standard_input().view(), "standard input", options);
}

Progress::When when(const Arguments& arguments) {
  if (arguments.quiet) return Progress::When::kNever;
  return arguments.progress ? Progress::When::kAlways : Progress::When::kIfSlow;
}

/// The points of a run, and where they were in the file.
struct Input {
  PointFile file;
  std::vector<std::size_t> index_in_file;
};

/// Throws IoError.
Input read(const Arguments& arguments, RunFacts& facts) {
  Input in{read_file_of(arguments), {}};
  std::vector<Point3>& points = in.file.points;
  facts.points = points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (arguments.skip_invalid && !finite(points[i])) continue;
    points[in.index_in_file.size()] = points[i];
    in.index_in_file.push_back(i);
  }
  points.resize(in.index_in_file.size());
  facts.skipped = facts.points - points.size();
  return in;
}

std::string no_solid(const Arguments& arguments, Span span, std::size_t distinct) {
  const std::string file = input_name(arguments) + ": ";
  const std::string points = std::to_string(distinct) + " distinct points";
  switch (span) {
    case Span::kNothing:
      return file + "no points; a solid needs at least 4";
    case Span::kPoint:
      return file + "only one distinct point; a solid needs at least 4";
    case Span::kLine:
      return file + points + ", all on one line: they span no solid";
    default:
      return file + points + ", all in one plane: they span no solid";
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

/// A failure with an exit status of its own.
struct Failure {
  ExitStatus status;
  std::string message;
};

/// Calls work with the points, and turns what it says of them into a Failure.
template <class Work>
auto with_points(const Arguments& arguments, const Input& in, Work&& work) {
  try {
    return work(in.file.points);
  } catch (const InvalidPoint& error) {
    throw Failure{kBadInput,
                  input_name(arguments) + ": " + error.what() + " (points count from 0" +
                      (finite(in.file.points[error.index()]) ? ")" : "; --skip-invalid drops it)")};
  } catch (const std::length_error& error) {
    throw Failure{kBadInput, input_name(arguments) + ": " + error.what()};
  }
}

/// Calls work, and turns an IoError into a Failure.
template <class Work>
auto or_fail(ExitStatus status, Work&& work) {
  try {
    return work();
  } catch (const IoError& error) {
    throw Failure{status, error.what()};
  }
}

int report(const Arguments& arguments, const Reconstruction& result, const RunFacts& facts,
           const std::vector<std::size_t>& index_in_file) {
  if (arguments.verbose) std::fputs(stage_lines(arguments, result, facts).c_str(), stderr);
  if (!arguments.quiet) std::fprintf(stderr, "%s\n", summary(arguments, result, facts).c_str());
  if (arguments.stats) {
    const std::string stats = stats_json(arguments, result, facts) + '\n';
    if (arguments.stats_file.empty()) {
      if (print(stats) != kDone) return kNoOutput;
    } else {
      or_fail(kNoOutput, [&] { write_text(stats, arguments.stats_file); });
    }
  }
  if (result.hidden.empty()) return kDone;
  report_hidden(result.hidden, index_in_file);
  return kHidden;
}

int reconstruct_points(const Arguments& arguments, const Input& in, RunFacts& facts,
                       const Clock& clock, Progress& progress) {
  or_fail(kNoOutput, [&] { try_outputs(arguments); });
  ReconstructOptions options = arguments.options;
  options.progress = std::ref(progress);
  const Reconstruction result =
      with_points(arguments, in, [&](const auto& points) { return reconstruct(points, options); });
  if (result.span != Span::kSolid) {
    throw Failure{kNoSolid, no_solid(arguments, result.span, result.counts.vertices)};
  }
  facts.topology = topology(result.mesh);
  progress("write", 0);
  const Clock write_clock;
  const auto lines = or_fail(kNoOutput, [&] {
    return write_outputs(arguments, in.file, result, facts.topology, in.index_in_file);
  });
  facts.seconds_write = write_clock.seconds();
  facts.seconds_total = clock.seconds();
  progress.clear();
  for (const std::string& line : lines) std::fprintf(stderr, "tetsculpt: %s\n", line.c_str());
  return report(arguments, result, facts, in.index_in_file);
}

int describe_points(const Arguments& arguments, const Input& in, const RunFacts& facts) {
  const PointFacts points = with_points(arguments, in, [&](const auto&) {
    return point_facts(in.file, input_name(arguments), facts.skipped, Spacing::kLeftOut);
  });
  if (!arguments.quiet) {
    const int status = print(facts_text(points));
    if (status != kDone) return status;
  }
  if (points.span == Span::kSolid) return kDone;
  throw Failure{kNoSolid, no_solid(arguments, points.span, points.distinct)};
}

}  // namespace

int run(const Arguments& arguments) {
  const Clock clock;
  Progress progress(when(arguments));
  try {
    progress("read", 0);
    RunFacts facts;
    const Input in = or_fail(kBadInput, [&] { return read(arguments, facts); });
    facts.seconds_read = clock.seconds();
    if (!arguments.dry_run) return reconstruct_points(arguments, in, facts, clock, progress);
    progress.clear();
    return describe_points(arguments, in, facts);
  } catch (const Failure& failure) {
    progress.clear();
    return fail(failure.status, failure.message);
  }
}

}  // namespace tetsculpt::cli
