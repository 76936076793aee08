#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/fit.h"
#include "bench/paper_run.h"

/// What bench_table1 prints on standard output.
namespace tetsculpt::bench {

/// One body at growing numbers of points.
struct Series {
  std::string name;
  std::vector<PaperRun> rows;
};

/// The seconds of the paper's Table 1, whole seconds of a Pentium III: solids without holes of 256,
/// 512, ..., 65536 points.
inline constexpr std::array<double, 9> kPaperSeconds{0, 0, 1, 3, 5, 13, 23, 41, 83};
/// The paper's time for so many points, if its table has them.
std::optional<double> paper_seconds(std::size_t points);
/// Those that aren't 0.
std::vector<Sample> paper_samples();

/// Whole times of each series over the number of points.
std::vector<Sample> total_samples(const Series& series);

/// The paper's table: its seconds, and those of each series beside them.
void print_table(std::span<const Series> all);
/// Times by stage, and what came out.
void print_stages(const Series& series);
/// Laws of growth fitted to the times of each stage over the number of points.
void print_growth(const Series& series);
/// Operations of sculpting, and their growth with points and tetrahedra.
void print_work(const Series& series);

}  // namespace tetsculpt::bench
