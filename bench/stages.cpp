// Time per stage and end to end, on random samples of surfaces and volumes, with fitted complexity.
//   build/release/bench/bench_stages --benchmark_filter=delaunay
#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "kernel/delaunay.h"
#include "kernel/emst.h"
#include "kernel/gabriel.h"
#include "sculpt/reconstruct.h"
#include "support/point_sets.h"

namespace tetsculpt {
namespace {

using Generator = std::vector<Point3> (*)(std::size_t n, std::uint64_t seed);

std::vector<Point3> grid_of(std::size_t n, std::uint64_t) {
  std::size_t side = 1;
  while (side * side * side < n) ++side;
  return point_sets::grid(side);
}

constexpr std::uint64_t kSeed = 2000;

void count_points(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetComplexityN(state.range(0));
}

void run_delaunay(benchmark::State& state, Generator generate) {
  const auto points = generate(static_cast<std::size_t>(state.range(0)), kSeed);
  std::size_t tetrahedra = 0;
  for (auto _ : state) tetrahedra = delaunay(distinct_points(points)).finite_tet_count();
  state.counters["tetrahedra"] = static_cast<double>(tetrahedra);
  count_points(state);
}

void run_graphs(benchmark::State& state, Generator generate) {
  const auto distinct = distinct_points(generate(static_cast<std::size_t>(state.range(0)), kSeed));
  const TetComplex complex = delaunay(distinct);
  for (auto _ : state) {
    const Flags gabriel = gabriel_edges(distinct.points, complex);
    benchmark::DoNotOptimize(emst(complex, edges_by_length(distinct.points, complex, gabriel)));
    benchmark::DoNotOptimize(extended_gabriel_hypergraph(distinct.points, complex, gabriel));
  }
  count_points(state);
}

void run_reconstruct(benchmark::State& state, Generator generate, Method method) {
  const auto points = generate(static_cast<std::size_t>(state.range(0)), kSeed);
  for (auto _ : state) benchmark::DoNotOptimize(reconstruct(points, {.method = method}));
  count_points(state);
}

template <class... Arguments>
void add(const std::string& name, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), arguments...)
      ->RangeMultiplier(4)
      ->Range(1 << 10, 1 << 18)
      ->Unit(benchmark::kMillisecond)
      ->Complexity();
}

void add_all() {
  const std::pair<const char*, Generator> sets[] = {{"cube", point_sets::uniform_cube},
                                                    {"bumpy_sphere", point_sets::bumpy_sphere},
                                                    {"torus", point_sets::random_torus},
                                                    {"grid", grid_of},
                                                    {"clusters", point_sets::clusters}};
  for (const auto& [name, generate] : sets) {
    add(std::string("delaunay/") + name, run_delaunay, generate);
    add(std::string("graphs/") + name, run_graphs, generate);
  }
  add("paper/bumpy_sphere", run_reconstruct, sets[1].second, Method::kPaper);
}

}  // namespace
}  // namespace tetsculpt

int main(int argc, char** argv) {
  tetsculpt::add_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
