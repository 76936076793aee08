#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "kernel/point.h"

/// Point sets that the benchmarks share, and how much memory they take.
namespace tetsculpt::bench {

struct Input {
  std::string name;
  /// About so many points, always the same ones.
  std::function<std::vector<Point3>(std::size_t)> generate;
  std::size_t most_points = 1 << 20;  ///< with more it takes too long to make or to work on
};

/// The closed surface on which whole reconstructions are compared.
Input surface_input();
/// Volumes and surfaces in general position.
std::vector<Input> smooth_inputs();
/// Sets that are full of ties, or whose complex is far from linear.
std::vector<Input> degenerate_inputs();

/// The points of a file. Throws what io/read_points throws.
std::vector<Point3> points_of_file(const std::string& path);

/// Forgets the highest memory use so far, where the system can.
void reset_peak_memory();
/// The highest memory use since then in bytes, or since the program's start; 0 if unknown.
std::size_t peak_memory();

}  // namespace tetsculpt::bench
