#pragma once

#include <span>

/// Growth laws fitted to measurements by least squares of the logarithms, so that every size counts
/// the same and a factor too much weighs what a factor too little does.
namespace tetsculpt::bench {

/// A measurement: a cost, positive, of work on size items, more than 1.
struct Sample {
  double size;
  double cost;
};

/// cost = factor * size^exponent.
struct PowerLaw {
  double factor = 0;
  double exponent = 0;
  double relative_error = 0;  ///< root mean square of log(measured / fitted)
};

/// cost = factor * size * log2(size).
struct LogLinearLaw {
  double factor = 0;
  double relative_error = 0;  ///< as for PowerLaw
};

/// Samples whose cost is not positive do not count: a clock that reads 0 says nothing. All zero
/// with fewer than two sizes.
PowerLaw fit_power(std::span<const Sample> samples);
/// Likewise; all zero without samples.
LogLinearLaw fit_log_linear(std::span<const Sample> samples);

/// The exponent that fit_power finds for size * log2(size) itself at the sizes of the samples: what
/// a measured exponent is to be held against.
double log_linear_exponent(std::span<const Sample> samples);

}  // namespace tetsculpt::bench
