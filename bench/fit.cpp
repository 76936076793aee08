#include "bench/fit.h"

#include <cmath>
#include <vector>

namespace tetsculpt::bench {
namespace {

struct LogSample {
  double x;  ///< log of the size
  double y;  ///< log of the cost
};

std::vector<LogSample> logarithms(std::span<const Sample> samples) {
  std::vector<LogSample> logs;
  for (const Sample& s : samples) {
    if (s.cost > 0) logs.push_back({std::log(s.size), std::log(s.cost)});
  }
  return logs;
}

double log_linear(double size) { return size * std::log2(size); }

}  // namespace

PowerLaw fit_power(std::span<const Sample> samples) {
  const std::vector<LogSample> logs = logarithms(samples);
  const auto count = static_cast<double>(logs.size());
  double mean_x = 0;
  double mean_y = 0;
  for (const auto& [x, y] : logs) {
    mean_x += x / count;
    mean_y += y / count;
  }
  double xx = 0;
  double xy = 0;
  for (const auto& [x, y] : logs) {
    xx += (x - mean_x) * (x - mean_x);
    xy += (x - mean_x) * (y - mean_y);
  }
  if (!(xx > 0)) return {};
  PowerLaw law;
  law.exponent = xy / xx;
  law.factor = std::exp(mean_y - law.exponent * mean_x);
  double squares = 0;
  for (const auto& [x, y] : logs) {
    const double miss = y - mean_y - law.exponent * (x - mean_x);
    squares += miss * miss;
  }
  law.relative_error = std::sqrt(squares / count);
  return law;
}

LogLinearLaw fit_log_linear(std::span<const Sample> samples) {
  std::vector<double> log_factors;
  double mean = 0;
  for (const Sample& s : samples) {
    if (s.cost > 0) log_factors.push_back(std::log(s.cost / log_linear(s.size)));
  }
  if (log_factors.empty()) return {};
  const auto count = static_cast<double>(log_factors.size());
  for (const double f : log_factors) mean += f / count;
  double squares = 0;
  for (const double f : log_factors) squares += (f - mean) * (f - mean);
  return {std::exp(mean), std::sqrt(squares / count)};
}

double log_linear_exponent(std::span<const Sample> samples) {
  std::vector<Sample> law;
  for (const Sample& s : samples) {
    if (s.cost > 0) law.push_back({s.size, log_linear(s.size)});
  }
  return fit_power(law).exponent;
}

}  // namespace tetsculpt::bench
