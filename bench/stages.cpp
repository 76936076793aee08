// Time of the stages after the Delaunay (for that see delaunay.cpp) and end to end, on random
// samples of surfaces and volumes, with fitted complexity.
//   build/release/bench/bench_stages --benchmark_filter=graphs
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "bench/inputs.h"
#include "kernel/delaunay.h"
#include "kernel/egh.h"
#include "kernel/emst.h"
#include "kernel/gabriel.h"
#include "sculpt/reconstruct.h"

namespace tetsculpt::bench {
namespace {

std::vector<Point3> points_of(const Input& input, const benchmark::State& state) {
  return input.generate(static_cast<std::size_t>(state.range(0)));
}

void count_points(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetComplexityN(state.range(0));
}

void run_graphs(benchmark::State& state, const Input& input) {
  const auto distinct = distinct_points(points_of(input, state));
  const TetComplex complex = delaunay(distinct);
  for (auto _ : state) {
    const Flags gabriel = gabriel_edges(distinct.points, complex);
    benchmark::DoNotOptimize(emst(complex, edges_by_length(distinct.points, complex, gabriel)));
    benchmark::DoNotOptimize(extended_gabriel_hypergraph(distinct.points, complex, gabriel));
  }
  count_points(state);
}

void run_reconstruct(benchmark::State& state, const Input& input, Method method) {
  const auto points = points_of(input, state);
  for (auto _ : state) benchmark::DoNotOptimize(reconstruct(points, {.method = method}));
  count_points(state);
}

constexpr std::int64_t kMostPoints = 1 << 18;

template <class... Arguments>
void add(const std::string& name, Arguments... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), arguments...)
      ->RangeMultiplier(4)
      ->Range(1 << 10, kMostPoints)
      ->Unit(benchmark::kMillisecond)
      ->Complexity();
}

void add_all() {
  for (const std::vector<Input>& inputs : {smooth_inputs(), degenerate_inputs()}) {
    for (const Input& input : inputs) {
      if (input.most_points >= std::size_t{kMostPoints})
        add("graphs/" + input.name, run_graphs, input);
    }
  }
  const Input surface = surface_input();
  add("paper/" + surface.name, run_reconstruct, surface, Method::kPaper);
}

}  // namespace
}  // namespace tetsculpt::bench

int main(int argc, char** argv) {
  tetsculpt::bench::add_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
