// Reading points: a million of them in each format, as a file in the page cache, in bytes/s; beside
// it the reading of the same bytes alone (file), and the conversion of the same numbers alone
// (numbers). Further arguments are point files.
//   build/release/bench/bench_io --benchmark_filter=ply
#include <benchmark/benchmark.h>

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "bench/inputs.h"
#include "io/byte_order.h"
#include "io/file_content.h"
#include "io/read_points.h"

namespace tetsculpt::bench {
namespace {

constexpr std::size_t kPoints = 1'000'000;

template <typename Number>
void append(std::string& bytes, Number value, std::endian order) {
  if (order != std::endian::native) value = reversed_bytes(value);
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  bytes.append(raw.data(), raw.size());
}

void append_text(std::string& text, double value) {
  std::array<char, 32> digits{};
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

std::string ply_header(const std::string& format, const std::string& type, const char* more) {
  const std::string property = "property " + type;
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(kPoints) + "\n" +
         property + " x\n" + property + " y\n" + property + " z\n" + more + "end_header\n";
}

template <typename Float>
std::string binary_ply(const std::vector<Point3>& points, const std::string& type,
                       std::endian order, bool colours) {
  const bool little = order == std::endian::little;
  std::string file =
      ply_header(little ? "binary_little_endian" : "binary_big_endian", type,
                 colours ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "");
  for (const Point3& p : points) {
    for (const double value : {p.x, p.y, p.z}) append(file, static_cast<Float>(value), order);
    if (colours) file += "rgb";
  }
  return file;
}

// `row` comes after the coordinates.
std::string text_rows(const std::vector<Point3>& points, const char* first, char between,
                      const std::string& row) {
  std::string text;
  for (const Point3& p : points) {
    text += first;
    append_text(text, p.x);
    text += between;
    append_text(text, p.y);
    text += between;
    append_text(text, p.z);
    text += row;
  }
  return text;
}

std::string binary_stl(const std::vector<Point3>& points) {
  std::string file(80, ' ');
  append(file, static_cast<std::uint32_t>(points.size() / 3), std::endian::little);
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    file.append(12, '\0');
    for (std::size_t k = i; k < i + 3; ++k) {
      for (const double value : {points[k].x, points[k].y, points[k].z}) {
        append(file, static_cast<float>(value), std::endian::little);
      }
    }
    file.append(2, '\0');
  }
  return file;
}

void rate(benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes) *
                          static_cast<std::int64_t>(state.iterations()));
}

void read_bytes(benchmark::State& state, const std::string& path) {
  std::size_t bytes = 0;
  for (auto _ : state) benchmark::DoNotOptimize(bytes = read_file(path).size);
  rate(state, bytes);
}

void read_all(benchmark::State& state, const std::string& path) {
  std::size_t points = 0;
  for (auto _ : state) points = read_points(path).points.size();
  rate(state, std::filesystem::file_size(path));
  using benchmark::Counter;
  state.counters["points/s"] =
      Counter(static_cast<double>(points), Counter::kIsIterationInvariantRate);
}

// The numbers of a text, as fast as the standard library takes them; nothing is stored.
void convert_numbers(benchmark::State& state, const std::string& path) {
  const FileContent content = read_file(path);
  double sum = 0;
  for (auto _ : state) {
    const char* const end = content.bytes.get() + content.size;
    for (const char* at = content.bytes.get(); at < end; ++at) {
      double value = 0;
      at = std::from_chars(at, end, value).ptr;
      sum += value;
    }
  }
  benchmark::DoNotOptimize(sum);
  rate(state, content.size);
}

void add(const std::string& path, const std::string& name) {
  const auto register_one = [&](const std::string& kind, auto* run) {
    benchmark::RegisterBenchmark((kind + "/" + name).c_str(),
                                 [=](benchmark::State& state) { run(state, path); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
  };
  register_one("file", read_bytes);
  register_one("points", read_all);
  if (name == "xyz") register_one("numbers", convert_numbers);
}

void add_made(const std::filesystem::path& directory) {
  const std::vector<Point3> points = surface_input().generate(kPoints);
  const auto add_file = [&](const std::string& name, const char* extension,
                            const std::string& content) {
    const std::string path = (directory / (name + extension)).string();
    std::ofstream(path, std::ios::binary) << content;
    add(path, name);
  };
  constexpr auto kLittle = std::endian::little;
  add_file("ply_float", ".ply", binary_ply<float>(points, "float", kLittle, false));
  add_file("ply_double", ".ply", binary_ply<double>(points, "double", kLittle, false));
  add_file("ply_big", ".ply", binary_ply<float>(points, "float", std::endian::big, false));
  add_file("ply_colours", ".ply", binary_ply<float>(points, "float", kLittle, true));
  add_file("ply_ascii", ".ply",
           ply_header("ascii", "double", "") + text_rows(points, "", ' ', "\n"));
  add_file("xyz", ".xyz", text_rows(points, "", ' ', "\n"));
  add_file("csv", ".csv", text_rows(points, "", ',', "\n"));
  add_file("xyz_colours", ".xyz", "//X Y Z R G B\n" + text_rows(points, "", ' ', " 255 0 17\n"));
  add_file("obj", ".obj", text_rows(points, "v ", ' ', "\n"));
  add_file("stl", ".stl", binary_stl(points));
}

}  // namespace
}  // namespace tetsculpt::bench

int main(int argc, char** argv) try {
  benchmark::Initialize(&argc, argv);
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / "tetsculpt_bench_io";
  std::filesystem::create_directories(directory);
  tetsculpt::bench::add_made(directory);
  for (const std::string& path : std::vector<std::string>(argv + 1, argv + argc)) {
    tetsculpt::bench::add(path, path);
  }
  benchmark::RunSpecifiedBenchmarks();
  std::filesystem::remove_all(directory);
} catch (const std::exception& error) {
  std::cerr << "bench_io: " << error.what() << '\n';
  return 1;
}
