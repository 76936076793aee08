// Table 1 of the paper, made again and continued: the time of its method for 256, 512, ... points
// of a solid without holes, beside the paper's own seconds; the same for solids with one and two
// holes; and the operations that its section 3.3 counts, on these and on two skew lines, whose
// complex has n^2/4 tetrahedra. Tables go to standard output, progress to standard error.
//   build/release/bench/bench_table1 [--most POINTS] [--svg FILE] [--benchmark_...]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/inputs.h"
#include "bench/paper_run.h"
#include "bench/svg_plot.h"
#include "bench/table1_text.h"
#include "support/point_sets.h"

namespace tetsculpt::bench {
namespace {

constexpr std::uint64_t kSeed = 2000;
constexpr std::size_t kFewestPoints = 256;
constexpr std::size_t kMostSkew = 2048;
constexpr std::size_t kMostRepeated = 131'072;

struct Options {
  std::size_t most = 65'536;
  std::string svg_file;
};

/// One cell of the table: a set of points and all runs on it.
struct Cell {
  std::size_t points;
  std::vector<PaperRun> runs;
};

struct Body {
  Input input;
  std::vector<Cell> cells;
};

std::vector<Body> bodies(std::size_t most) {
  const Input one_hole{"one hole",
                       [](std::size_t n) { return point_sets::random_torus(n, kSeed); }};
  const Input two_holes{"two holes",
                        [](std::size_t n) { return point_sets::random_double_torus(n, kSeed); }};
  const Input lines{"skew lines", [](std::size_t n) { return point_sets::skew_lines(n / 2); },
                    kMostSkew};
  std::vector<Body> all{{surface_input(), {}}, {one_hole, {}}, {two_holes, {}}, {lines, {}}};
  all.front().input.name = "no hole";
  for (Body& body : all) {
    for (std::size_t n = kFewestPoints; n <= std::min(most, body.input.most_points); n *= 2) {
      body.cells.push_back({n, {}});
    }
  }
  return all;
}

/// At least three runs of each cell, more of small ones, but one of the largest. Keeps references
/// to the bodies.
void add_all(std::vector<Body>& all) {
  for (Body& body : all) {
    for (Cell& cell : body.cells) {
      const auto run = [&body, &cell](benchmark::State& state) {
        const std::vector<Point3> points = body.input.generate(cell.points);
        for (auto _ : state) {
          cell.runs.push_back(run_paper(points));
          state.SetIterationTime(cell.runs.back().total_seconds());
        }
      };
      const std::string name = body.input.name + "/" + std::to_string(cell.points);
      benchmark::RegisterBenchmark(name.c_str(), run)
          ->UseManualTime()
          ->MinTime(0.2)
          ->Repetitions(cell.points <= kMostRepeated ? 3 : 1)
          ->DisplayAggregatesOnly(true)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

Series series_of(const Body& body) {
  Series series{body.input.name, {}};
  for (const Cell& cell : body.cells) {
    if (!cell.runs.empty()) series.rows.push_back(typical(cell.runs));
  }
  return series;
}

std::vector<PlotPoint> plot_points(const std::vector<Sample>& samples) {
  std::vector<PlotPoint> points;
  for (const Sample& s : samples) points.push_back({s.size, s.cost});
  return points;
}

LogLogPlot plot_of(const std::vector<Series>& solids) {
  LogLogPlot plot{"Table 1 again: points to surface by the paper's method",
                  "points",
                  "seconds, input and output not timed",
                  {}};
  plot.curves.push_back(
      {"paper: Pentium III, no hole", plot_points(paper_samples()), Curve::Style::kLine});
  for (const Series& series : solids) {
    plot.curves.push_back(
        {"tetsculpt, " + series.name, plot_points(total_samples(series)), Curve::Style::kLine});
  }
  const std::vector<Sample> totals = total_samples(solids.front());
  const LogLinearLaw law = fit_log_linear(totals);
  Curve fitted{"c n log n through \"" + solids.front().name + "\"", {}, Curve::Style::kDashes};
  for (const Sample& s : totals) {
    fitted.points.push_back({s.size, law.factor * s.size * std::log2(s.size)});
  }
  plot.curves.push_back(std::move(fitted));
  return plot;
}

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t k = 0; k < arguments.size(); k += 2) {
    if (k + 1 == arguments.size()) throw std::invalid_argument("no value for " + arguments[k]);
    if (arguments[k] == "--most") {
      options.most = std::stoul(arguments[k + 1]);
    } else if (arguments[k] == "--svg") {
      options.svg_file = arguments[k + 1];
    } else {
      throw std::invalid_argument("unknown option " + arguments[k]);
    }
  }
  if (options.most < kFewestPoints) throw std::invalid_argument("--most is 256 or more");
  return options;
}

void run(const Options& options) {
  std::vector<Body> all = bodies(options.most);
  add_all(all);
  benchmark::ConsoleReporter progress(benchmark::ConsoleReporter::OO_None);
  progress.SetOutputStream(&std::cerr);
  progress.SetErrorStream(&std::cerr);
  benchmark::RunSpecifiedBenchmarks(&progress);

  std::vector<Series> measured;
  std::vector<Series> solids;
  for (const Body& body : all) {
    Series series = series_of(body);
    if (series.rows.empty()) continue;  // filtered out
    if (body.input.most_points > kMostSkew) solids.push_back(series);
    measured.push_back(std::move(series));
  }
  if (!solids.empty()) print_table(solids);
  for (const Series& series : solids) print_stages(series);
  for (const Series& series : solids) print_growth(series);
  for (const Series& series : measured) print_work(series);
  if (options.svg_file.empty() || solids.empty()) return;
  std::ofstream file(options.svg_file);
  file << svg(plot_of(solids));
  if (!file.flush()) throw std::runtime_error("cannot write " + options.svg_file);
}

}  // namespace
}  // namespace tetsculpt::bench

int main(int argc, char** argv) try {
  benchmark::Initialize(&argc, argv);
  tetsculpt::bench::run(tetsculpt::bench::parse(std::vector<std::string>(argv + 1, argv + argc)));
} catch (const std::exception& error) {
  std::cerr << "bench_table1: " << error.what() << '\n';
  return 1;
}
