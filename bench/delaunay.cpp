// The Delaunay tetrahedralization, 1k to 1M points: tetrahedra with neighbours (hull), and the
// complex with edges and triangles too (complex); with fitted complexity. Further arguments are
// point files.
//   build/release/bench/bench_delaunay --benchmark_filter=hull/cube build/points/*.xyz
#include "kernel/delaunay.h"

#include <benchmark/benchmark.h>

#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "bench/inputs.h"
#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"

namespace tetsculpt::bench {
namespace {

std::size_t make_hull(const std::vector<Point3>& points, int threads) {
  return lifted_hull(distinct_points(points, threads).points, {.threads = threads}).finite_count;
}

std::size_t make_complex(const std::vector<Point3>& points, int threads) {
  return delaunay(distinct_points(points, threads), {.threads = threads}).finite_tet_count();
}

using Make = std::size_t (*)(const std::vector<Point3>& points, int threads);

void run(benchmark::State& state, const std::vector<Point3>& points, Make make, int threads) {
  std::size_t tetrahedra = 0;
  reset_peak_memory();
  const std::size_t before = peak_memory();
  for (auto _ : state) tetrahedra = make(points, threads);
  const auto n = static_cast<double>(points.size());
  using benchmark::Counter;
  state.counters["points/s"] = Counter(n, Counter::kIsIterationInvariantRate);
  state.counters["tetrahedra/s"] =
      Counter(static_cast<double>(tetrahedra), Counter::kIsIterationInvariantRate);
  state.counters["tetrahedra"] = static_cast<double>(tetrahedra);
  state.counters["bytes/point"] = static_cast<double>(peak_memory() - before) / n;
  state.SetComplexityN(static_cast<benchmark::IterationCount>(points.size()));
}

void add(const Input& input, const std::string& kind, Make make, int threads) {
  const std::string name = kind + "/" + input.name + "/threads:" + std::to_string(threads);
  benchmark::RegisterBenchmark(
      name.c_str(),
      [=](benchmark::State& state) {
        run(state, input.generate(static_cast<std::size_t>(state.range(0))), make, threads);
      })
      ->RangeMultiplier(8)
      ->Range(1 << 10, static_cast<std::int64_t>(input.most_points))
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->Complexity();
}

void add_all(const std::vector<std::string>& files) {
  std::vector<Input> inputs = smooth_inputs();
  for (const Input& input : degenerate_inputs()) inputs.push_back(input);
  for (const Input& input : inputs) {
    add(input, "hull", make_hull, 1);
    add(input, "hull", make_hull, 2);
    add(input, "complex", make_complex, 1);
    add(input, "complex", make_complex, 2);
  }
  for (const std::string& file : files) {
    const Input input{file, [=](std::size_t) { return points_of_file(file); }, 1 << 10};
    add(input, "hull", make_hull, 1);
    add(input, "complex", make_complex, 1);
  }
}

}  // namespace
}  // namespace tetsculpt::bench

int main(int argc, char** argv) try {
  benchmark::Initialize(&argc, argv);
  tetsculpt::bench::add_all(std::vector<std::string>(argv + 1, argv + argc));
  benchmark::RunSpecifiedBenchmarks();
} catch (const std::exception& error) {
  std::cerr << "bench_delaunay: " << error.what() << '\n';
  return 1;
}
