// This library and its peers on the same points, in turn in one process: medians of several rounds,
// and ratios. Peers are those that were found when this was built: CGAL, HXT, TetGen, Qhull.
//   build/release/bench/bench_peers [--rounds N] [--most POINTS] [FILE ...]
#include "bench/peers.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "bench/inputs.h"
#include "kernel/delaunay.h"
#include "kernel/distinct_points.h"
#include "kernel/lifted_hull.h"
#include "sculpt/reconstruct.h"

namespace tetsculpt::bench {
namespace {

struct Contestant {
  std::string name;
  /// Returns the number of finite tetrahedra, or of triangles of a surface.
  std::function<std::size_t(const std::vector<Point3>&)> run;
  std::size_t most_points = 2'000'000;
};

std::vector<Contestant> contestants() {
  const auto hull = [](int threads) {
    return [=](const std::vector<Point3>& points) {
      return lifted_hull(distinct_points(points, threads).points, {.threads = threads})
          .finite_count;
    };
  };
  const auto complex = [](int threads) {
    return [=](const std::vector<Point3>& points) {
      return delaunay(distinct_points(points, threads), {.threads = threads}).finite_tet_count();
    };
  };
  std::vector<Contestant> all{{"hull", hull(1)},
                              {"hull, 2 threads", hull(2)},
                              {"complex", complex(1)},
                              {"complex, 2 threads", complex(2)},
                              {"surface, guided", [](const std::vector<Point3>& points) {
                                 return reconstruct(points).mesh.triangles.size();
                               }}};
  for (const Peer& peer : peers()) all.push_back({peer.name, peer.tetrahedra, peer.most_points});
  return all;
}

double seconds_of(const Contestant& contestant, const std::vector<Point3>& points,
                  std::size_t& count) {
  const auto start = std::chrono::steady_clock::now();
  count = contestant.run(points);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void compare(const std::string& set, const std::vector<Point3>& points, int rounds) {
  const std::vector<Contestant> all = contestants();
  std::vector<std::vector<double>> seconds(all.size());
  std::vector<std::size_t> counts(all.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t c = 0; c < all.size(); ++c) {
      if (points.size() > all[c].most_points) continue;
      seconds[c].push_back(seconds_of(all[c], points, counts[c]));
    }
  }
  std::printf("%s, %zu points\n", set.c_str(), points.size());
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (seconds[c].empty()) continue;
    const double time = median(seconds[c]);
    std::printf("  %-18s %10.1f ms  %5.2f of hull  %10zu put out\n", all[c].name.c_str(),
                1e3 * time, time / median(seconds[0]), counts[c]);
  }
  std::fflush(stdout);
}

void compare_all(const std::vector<std::string>& arguments) {
  int rounds = 5;
  std::size_t most = 100'000;
  std::vector<std::string> files;
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    if (arguments[k] == "--rounds" && k + 1 < arguments.size()) {
      rounds = std::stoi(arguments[++k]);
    } else if (arguments[k] == "--most" && k + 1 < arguments.size()) {
      most = std::stoul(arguments[++k]);
    } else {
      files.push_back(arguments[k]);
    }
  }
  for (const std::size_t n : {std::size_t{65'536}, std::size_t{1'000'000}}) {
    if (n > most) continue;
    std::vector<Input> inputs = smooth_inputs();
    for (const Input& input : degenerate_inputs()) inputs.push_back(input);
    for (const Input& input : inputs) {
      if (n == 65'536 || n <= input.most_points) {
        compare(input.name, input.generate(std::min(n, input.most_points)), rounds);
      }
    }
  }
  for (const std::string& file : files) compare(file, points_of_file(file), rounds);
}

}  // namespace
}  // namespace tetsculpt::bench

int main(int argc, char** argv) try {
  tetsculpt::bench::compare_all(std::vector<std::string>(argv + 1, argv + argc));
} catch (const std::exception& error) {
  std::cerr << "bench_peers: " << error.what() << '\n';
  return 1;
}
