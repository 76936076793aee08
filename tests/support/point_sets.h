#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "kernel/point.h"

/// Point sets for tests and benchmarks. Seeds are arguments; the same arguments give the same
/// points on every platform (no library distribution is used).
namespace tetsculpt::point_sets {

/// Uniform pseudo-random numbers from a 64-bit counter (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [0, n).
  std::size_t below(std::size_t n) { return bits() % n; }

 private:
  std::uint64_t state_;
};

struct NamedPoints {
  std::string name;
  std::vector<Point3> points;
};

/// A permutation of the points.
std::vector<Point3> shuffled(std::vector<Point3> points, std::uint64_t seed);

// Volumes and degenerate sets.
std::vector<Point3> uniform_cube(std::size_t n, std::uint64_t seed);
/// All points of {0..side-1}^3, times spacing.
std::vector<Point3> grid(std::size_t side, double spacing = 1);
/// n points of {0..side-1}^3, repeats likely.
std::vector<Point3> random_lattice(std::size_t n, std::size_t side, std::uint64_t seed);
/// All integer points with x^2 + y^2 + z^2 == squared_radius: exactly cospherical.
std::vector<Point3> lattice_sphere(long squared_radius);
/// n points on each of two skew lines: about n^2 tetrahedra.
std::vector<Point3> skew_lines(std::size_t n);
/// n points in the plane z = 0 and one above it.
std::vector<Point3> plane_and_apex(std::size_t n, std::uint64_t seed);
/// Clusters of points about 1e-12 apart, at integer places.
std::vector<Point3> clusters(std::size_t n, std::uint64_t seed);

// Random, area-uniform samples of surfaces.
/// Radius 1 + 0.15 sin(5 theta) sin(4 phi) over uniform directions.
std::vector<Point3> bumpy_sphere(std::size_t n, std::uint64_t seed);
/// Radii 1 and 0.4.
std::vector<Point3> random_torus(std::size_t n, std::uint64_t seed);
/// The surface of double_torus; to a few per cent uniform.
std::vector<Point3> random_double_torus(std::size_t n, std::uint64_t seed);

// Well-sampled closed surfaces: points at least `spacing` apart, dense but irregular (dart
// throwing).
std::vector<Point3> sphere(double spacing, std::uint64_t seed);
std::vector<Point3> ellipsoid(double spacing, std::uint64_t seed);  ///< half axes 1, 0.7, 0.5
std::vector<Point3> torus(double spacing, std::uint64_t seed);      ///< radii 1 and 0.4; genus 1
/// Around a lemniscate, in about [-1.1, 1.1]^2 x [-0.2, 0.2]; genus 2.
std::vector<Point3> double_torus(double spacing, std::uint64_t seed);
/// Surface of [0, 1]^3 with its corners and evenly sampled edges.
std::vector<Point3> cube_surface(double spacing, std::uint64_t seed);

std::vector<Point3> translated(std::vector<Point3> points, const Point3& by);
std::vector<Point3> scaled(std::vector<Point3> points, double by);
std::vector<Point3> joined(std::vector<Point3> a, const std::vector<Point3>& b);

}  // namespace tetsculpt::point_sets
