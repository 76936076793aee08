#include "bench/inputs.h"

#include <fstream>
#include <numeric>
#include <string>

#include "io/read_points.h"
#include "support/point_sets.h"

namespace tetsculpt::bench {
namespace {

constexpr std::uint64_t kSeed = 2000;

std::vector<Point3> grid_of(std::size_t n) {
  std::size_t side = 1;
  while ((side + 1) * (side + 1) * (side + 1) <= n) ++side;
  return point_sets::grid(side);
}

/// The points of the integer lattice at one distance from the origin: all exactly cospherical.
std::vector<Point3> lattice_sphere_of(std::size_t n) {
  // There are some 2 pi r of them for r^2 = 1 modulo 4 without square divisors, up to a factor.
  const auto squared = static_cast<long>(n) * static_cast<long>(n) / 36;
  return point_sets::lattice_sphere(squared - squared % 8 + 5);
}

}  // namespace

Input surface_input() {
  return {"bumpy_sphere", [](std::size_t n) { return point_sets::bumpy_sphere(n, kSeed); }};
}

std::vector<Input> smooth_inputs() {
  return {{"cube", [](std::size_t n) { return point_sets::uniform_cube(n, kSeed); }},
          surface_input(),
          {"torus", [](std::size_t n) { return point_sets::random_torus(n, kSeed); }},
          {"clusters", [](std::size_t n) { return point_sets::clusters(n, kSeed); }}};
}

std::vector<Input> degenerate_inputs() {
  const auto doubled = [](std::size_t n) {
    const auto points = point_sets::uniform_cube(n / 2, kSeed);
    return point_sets::joined(points, points);
  };
  const auto two_lines = [](std::size_t n) { return point_sets::skew_lines(n / 2); };
  return {{"grid", grid_of},
          {"lattice_sphere", lattice_sphere_of, 100'000},
          {"skew_lines", two_lines, 2'000},
          {"doubled_cube", doubled},
          {"plane_and_apex", [](std::size_t n) { return point_sets::plane_and_apex(n, kSeed); }}};
}

std::vector<Point3> points_of_file(const std::string& path) { return read_points(path).points; }

void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

std::size_t peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

}  // namespace tetsculpt::bench
