// Whole complexes against exact integers that share nothing with the kernel's predicates: every
// tetrahedron is positively oriented, the apex across each facet is not inside its (perturbed)
// sphere, and the hull is convex at each of its edges. In a valid complex that is the whole
// empty-sphere property, by the local criterion.
//   build/release/bench/bench_verify [POINTS] [FILE ...]
// Exit status 1 if anything was wrong. A million points take minutes.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <exception>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "bench/inputs.h"
#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/parallel.h"
#include "support/exact_predicates.h"

namespace tetsculpt::bench {
namespace {

/// Corners of t, the apex of its neighbour across facet i in the place of infinity; and that apex.
std::array<Point3, 5> facing(const DistinctPoints& distinct, const TetComplex& complex, TetId t,
                             int i) {
  const Facet other = complex.across(t, i);
  std::array<Point3, 5> p;
  p[4] = distinct.points[+complex.vertices(other.tet)[static_cast<std::size_t>(other.corner)]];
  for (std::size_t k = 0; k < 4; ++k) {
    const VertexId v = complex.vertices(t)[k];
    p[k] = v == kInfinite ? p[4] : distinct.points[+v];
  }
  return p;
}

bool wrong_facet(const DistinctPoints& distinct, const TetComplex& complex, TetId t, int i) {
  const bool finite = complex.finite(t);
  if (complex.finite(complex.neighbor(t, i)) != finite) return false;
  if (complex.neighbor(t, i) < t) return false;  // the test is the same from both sides
  const auto p = facing(distinct, complex, t, i);
  if (!finite) return exact::orient3d(p[0], p[1], p[2], p[3]) == Sign::kPositive;
  return exact::in_perturbed_sphere(p[0], p[1], p[2], p[3], p[4]).inside;
}

bool wrong_orientation(const DistinctPoints& distinct, const TetComplex& complex, TetId t) {
  if (!complex.finite(t)) return false;
  std::array<Point3, 4> p;
  for (std::size_t k = 0; k < 4; ++k) p[k] = distinct.points[+complex.vertices(t)[k]];
  return exact::orient3d(p[0], p[1], p[2], p[3]) != Sign::kPositive;
}

/// Prints a line; true if all is well.
bool verify(const std::string& name, const std::vector<Point3>& points) {
  const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const DistinctPoints distinct = distinct_points(points);
  const TetComplex complex = delaunay(distinct, {.threads = threads});
  std::atomic<std::size_t> wrong = broken_invariant(complex, distinct.points) ? 1 : 0;
  parallel_ranges(complex.tet_count(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const TetId t{static_cast<std::uint32_t>(k)};
      wrong += wrong_orientation(distinct, complex, t);
      for (int i = 0; i < 4; ++i) wrong += wrong_facet(distinct, complex, t, i);
    }
  });
  std::cout << name << ": " << distinct.points.size() << " points, " << complex.finite_tet_count()
            << " tetrahedra, " << wrong << " wrong" << std::endl;
  return wrong == 0;
}

bool verify_all(const std::vector<std::string>& arguments) {
  const std::size_t n = arguments.empty() ? 20'000 : std::stoul(arguments[0]);
  bool good = true;
  for (const auto& inputs : {smooth_inputs(), degenerate_inputs()}) {
    for (const Input& input : inputs) {
      good &= verify(input.name, input.generate(std::min(n, input.most_points)));
    }
  }
  for (std::size_t k = 1; k < arguments.size(); ++k) {
    good &= verify(arguments[k], points_of_file(arguments[k]));
  }
  return good;
}

}  // namespace
}  // namespace tetsculpt::bench

int main(int argc, char** argv) try {
  return tetsculpt::bench::verify_all(std::vector<std::string>(argv + 1, argv + argc)) ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "bench_verify: " << error.what() << '\n';
  return 1;
}
