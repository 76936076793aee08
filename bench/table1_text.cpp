#include "bench/table1_text.h"

#include <cmath>
#include <cstdio>

namespace tetsculpt::bench {
namespace {

double as_double(std::size_t count) { return static_cast<double>(count); }

std::vector<Sample> stage_samples(const Series& series, std::size_t stage) {
  std::vector<Sample> samples;
  for (const PaperRun& run : series.rows) {
    samples.push_back({as_double(run.points), run.seconds[stage]});
  }
  return samples;
}

void print_laws(const char* name, const std::vector<Sample>& samples) {
  const PowerLaw power = fit_power(samples);
  const LogLinearLaw log_linear = fit_log_linear(samples);
  std::printf("  %-10s  %9.3g  %5.3f  %4.0f %%   %9.2f  %4.0f %%\n", name, power.factor,
              power.exponent, 100 * power.relative_error, 1e9 * log_linear.factor,
              100 * log_linear.relative_error);
}

/// A number of operations in a run.
struct Operation {
  const char* name;
  double (*count)(const PaperRun&);
};

constexpr std::array<Operation, 5> kOperations{
    {{"tetrahedra", [](const PaperRun& run) { return as_double(run.tetrahedra); }},
     {"looks", [](const PaperRun& run) { return as_double(run.work.looks); }},
     {"pushes", [](const PaperRun& run) { return as_double(run.work.pushes); }},
     {"removals", [](const PaperRun& run) { return as_double(run.removed); }},
     {"bases", [](const PaperRun& run) { return as_double(run.work.bases); }}}};

}  // namespace

std::optional<double> paper_seconds(std::size_t points) {
  for (std::size_t i = 0; i < kPaperSeconds.size(); ++i) {
    if (std::size_t{256} << i == points) return kPaperSeconds[i];
  }
  return std::nullopt;
}

std::vector<Sample> paper_samples() {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < kPaperSeconds.size(); ++i) {
    if (kPaperSeconds[i] > 0)
      samples.push_back({as_double(std::size_t{256} << i), kPaperSeconds[i]});
  }
  return samples;
}

std::vector<Sample> total_samples(const Series& series) {
  std::vector<Sample> samples;
  for (const PaperRun& run : series.rows) {
    samples.push_back({as_double(run.points), run.total_seconds()});
  }
  return samples;
}

void print_table(std::span<const Series> all) {
  std::printf(
      "Processor seconds from points to surface, one thread, input and output not timed\n\n");
  std::printf("   points   paper");
  for (const Series& series : all) std::printf("  %12s", series.name.c_str());
  std::printf("\n");
  for (std::size_t row = 0; row < all.front().rows.size(); ++row) {
    const std::size_t points = all.front().rows[row].points;
    std::printf("  %7zu", points);
    if (const auto seconds = paper_seconds(points)) {
      std::printf("  %6.0f", *seconds);
    } else {
      std::printf("  %6s", "");
    }
    for (const Series& series : all) {
      if (row < series.rows.size()) std::printf("  %12.4f", series.rows[row].total_seconds());
    }
    std::printf("\n");
  }
  std::printf("  exponent  %5.2f", fit_power(paper_samples()).exponent);
  for (const Series& series : all) {
    std::printf("  %12.2f", fit_power(total_samples(series)).exponent);
  }
  std::printf("\n\n");
}

void print_stages(const Series& series) {
  std::printf("%s: milliseconds by stage\n\n", series.name.c_str());
  std::printf("   points  tetrahedra");
  for (const std::string_view stage : kStageNames) {
    std::printf("  %9.*s", static_cast<int>(stage.size()), stage.data());
  }
  std::printf("      total  holes  genus  hidden\n");
  for (const PaperRun& run : series.rows) {
    std::printf("  %7zu  %10zu", run.points, run.tetrahedra);
    for (const double seconds : run.seconds) std::printf("  %9.2f", 1e3 * seconds);
    std::printf("  %9.2f  %5zu  %5zu  %6zu\n", 1e3 * run.total_seconds(), run.holes, run.genus(),
                run.hidden);
  }
  std::printf("\n");
}

void print_growth(const Series& series) {
  const std::vector<Sample> totals = total_samples(series);
  std::printf("%s: growth of the time t (n log n itself would have k = %.3f)\n\n",
              series.name.c_str(), log_linear_exponent(totals));
  std::printf("               t = c n^k            t = c n log2 n\n");
  std::printf("                  c, s      k   error     c, ns   error\n");
  for (std::size_t stage = 0; stage < kStageNames.size(); ++stage) {
    print_laws(kStageNames[stage].data(), stage_samples(series, stage));
  }
  print_laws("total", totals);
  std::printf("\n");
}

void print_work(const Series& series) {
  std::printf("%s: operations of sculpting for each tetrahedron of the complex\n\n",
              series.name.c_str());
  std::printf("   points  tetrahedra  holes");
  for (const Operation& operation : kOperations) std::printf("  %10s", operation.name);
  std::printf("          ns\n");
  for (const PaperRun& run : series.rows) {
    const double tetrahedra = as_double(run.tetrahedra);
    std::printf("  %7zu  %10zu  %5zu", run.points, run.tetrahedra, run.holes);
    for (const Operation& operation : kOperations) {
      std::printf("  %10.3f", operation.count(run) / tetrahedra);
    }
    const double seconds = run.seconds[static_cast<std::size_t>(Stage::kSculpt)];
    std::printf("  %10.0f\n", 1e9 * seconds / tetrahedra);
  }
  for (const char* over : {"points", "tetrahedra"}) {
    const bool by_points = over == std::string("points");
    std::printf("  exponent over %-10s  ", over);
    for (const Operation& operation : kOperations) {
      std::vector<Sample> samples;
      for (const PaperRun& run : series.rows) {
        samples.push_back(
            {as_double(by_points ? run.points : run.tetrahedra), operation.count(run)});
      }
      std::printf("  %10.3f", fit_power(samples).exponent);
    }
    std::printf("\n");
  }
  std::printf("\n");
}

}  // namespace tetsculpt::bench
