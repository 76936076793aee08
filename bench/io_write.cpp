// Throughput of the writers into the page cache, beside that of writing the same bytes as they are,
// and of a copy of the file. Every file is a new one, but for those called "replaced": to rename a
// file over another makes some file systems (ext4) send its bytes to the disk at once.
//   build/release/bench/bench_io_write --benchmark_filter=ply
#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "io/atomic_file.h"
#include "io/vertex_normals.h"
#include "io/write_mesh.h"
#include "tests/support/point_sets.h"

namespace tetsculpt::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kSide = 1000;  // a million points, two million triangles

/// A torus of squares in its connections, with random points: what text takes longest for.
TriangleMesh mesh() {
  TriangleMesh result{point_sets::uniform_cube(std::size_t{kSide} * kSide, 1), {}};
  const auto at = [](std::uint32_t i, std::uint32_t j) { return i % kSide * kSide + j % kSide; };
  for (std::uint32_t i = 0; i < kSide; ++i) {
    for (std::uint32_t j = 0; j < kSide; ++j) {
      result.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      result.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  }
  return result;
}

std::vector<Attribute> attributes(const TriangleMesh& mesh) {
  const std::vector<std::uint8_t> bytes(mesh.points.size(), 77);
  std::vector<Attribute> all = vertex_normal_attributes(mesh);
  for (const char* name : {"red", "green", "blue"}) all.push_back({name, bytes});
  return all;
}

fs::path target() { return fs::temp_directory_path() / "tetsculpt_bench_io_write"; }

void count_bytes(benchmark::State& state) {
  const auto size = static_cast<std::int64_t>(fs::file_size(target()));
  state.SetBytesProcessed(state.iterations() * size);
  state.counters["MB"] = static_cast<double>(size) / 1e6;
  fs::remove(target());
}

void remove_target(benchmark::State& state) {
  state.PauseTiming();
  fs::remove(target());
  state.ResumeTiming();
}

void run_write(benchmark::State& state, const TriangleMesh& mesh, const WriteMeshOptions& options) {
  for (auto _ : state) {
    remove_target(state);
    benchmark::DoNotOptimize(write_mesh(mesh, target(), options));
  }
  count_bytes(state);
}

void run_replace(benchmark::State& state, const TriangleMesh& mesh) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(write_mesh(mesh, target(), {.format = MeshFormat::kPly}));
  }
  count_bytes(state);
}

/// The yardsticks: the bytes of a binary PLY file at once.
std::string bytes_of(const TriangleMesh& mesh) {
  write_mesh(mesh, target(), {.format = MeshFormat::kPly});
  std::ifstream in(target(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void run_fwrite(benchmark::State& state, const TriangleMesh& mesh) {
  const std::string bytes = bytes_of(mesh);
  for (auto _ : state) {
    remove_target(state);
    std::FILE* file = std::fopen(target().string().c_str(), "wb");
    benchmark::DoNotOptimize(std::fwrite(bytes.data(), 1, bytes.size(), file));
    std::fclose(file);
  }
  count_bytes(state);
}

void run_atomic_file(benchmark::State& state, const TriangleMesh& mesh) {
  const std::string bytes = bytes_of(mesh);
  for (auto _ : state) {
    remove_target(state);
    AtomicFile file(target());
    file.write(bytes);
    file.commit();
  }
  count_bytes(state);
}

void run_copy(benchmark::State& state, const TriangleMesh& mesh) {
  const fs::path source = target().string() + "_source";
  write_mesh(mesh, source, {.format = MeshFormat::kPly});
  for (auto _ : state) {
    remove_target(state);
    fs::copy_file(source, target());
  }
  count_bytes(state);
  fs::remove(source);
}

template <class... Arguments>
void add(const std::string& name, const Arguments&... arguments) {
  benchmark::RegisterBenchmark(name.c_str(), arguments...)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

void add_all(const TriangleMesh& mesh, const std::vector<Attribute>& attributes) {
  add("yardstick/fwrite", [&](benchmark::State& state) { run_fwrite(state, mesh); });
  add("yardstick/copy", [&](benchmark::State& state) { run_copy(state, mesh); });
  add("yardstick/atomic_file", [&](benchmark::State& state) { run_atomic_file(state, mesh); });
  add("replaced/ply", [&](benchmark::State& state) { run_replace(state, mesh); });
  const auto add_format = [&](const std::string& name, WriteMeshOptions options) {
    add(name, [&mesh, options](benchmark::State& state) { run_write(state, mesh, options); });
    options.attributes = attributes;
    add(name + "/attributes",
        [&mesh, options](benchmark::State& state) { run_write(state, mesh, options); });
  };
  for (const char* name : {"ply", "obj", "off", "stl", "wrl", "gltf", "glb", "vtk"}) {
    add_format(name, {.format = mesh_format_named(name)});
  }
  add_format("ply_ascii", {.format = MeshFormat::kPly, .ply_encoding = PlyEncoding::kAscii});
}

}  // namespace
}  // namespace tetsculpt::bench

int main(int argc, char** argv) {
  const tetsculpt::TriangleMesh mesh = tetsculpt::bench::mesh();
  const std::vector<tetsculpt::Attribute> attributes = tetsculpt::bench::attributes(mesh);
  tetsculpt::bench::add_all(mesh, attributes);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
