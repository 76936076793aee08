#include "sculpt/star_faults.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "kernel/large_array.h"

namespace tetsculpt {
namespace {

/// One triangle at a vertex: the next corner and the one after it.
struct Wedge {
  VertexId from;
  VertexId to;
};

/// Above so many triangles, following the fan by search takes too long.
constexpr std::size_t kLargeFan = 24;

/// Follows the wedges from the first one. Precondition: at least one wedge, none twice.
bool is_single_fan(std::span<Wedge> wedges) {
  const auto from_less = [](const Wedge& a, const Wedge& b) { return a.from < b.from; };
  const bool sorted = wedges.size() > kLargeFan;
  if (sorted) std::sort(wedges.begin(), wedges.end(), from_less);
  const auto next = [&](VertexId at) {
    return sorted ? std::lower_bound(wedges.begin(), wedges.end(), Wedge{at, at}, from_less)
                  : std::find_if(wedges.begin(), wedges.end(),
                                 [&](const Wedge& w) { return w.from == at; });
  };
  // Every neighbour has as many wedges in as out, so this comes back to where it started; it does
  // not pass through all wedges if there are several fans or a neighbour has several wedges out.
  const VertexId start = wedges.front().from;
  VertexId at = start;
  std::size_t steps = 0;
  do {
    at = next(at)->to;
    ++steps;
  } while (at != start && steps < wedges.size());
  return at == start && steps == wedges.size();
}

}  // namespace

StarFaults star_faults(std::size_t vertex_count,
                       std::span<const std::array<VertexId, 3>> triangles) {
  LargeArray<std::uint32_t> first(vertex_count + 1, 0);
  for (const auto& corners : triangles) {
    for (const VertexId v : corners) ++first[+v + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  LargeArray<Wedge> wedges(first.back());
  LargeArray<std::uint32_t> end(first.begin(), first.end() - 1);
  for (const auto& [a, b, c] : triangles) {
    wedges[end[+a]++] = {b, c};
    wedges[end[+b]++] = {c, a};
    wedges[end[+c]++] = {a, b};
  }
  StarFaults faults;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const auto fan = std::span(wedges).subspan(first[v], first[v + 1] - first[v]);
    if (fan.empty()) {
      faults.hidden.push_back(VertexId{v});
    } else if (!is_single_fan(fan)) {
      faults.bad.push_back(VertexId{v});
    }
  }
  return faults;
}

}  // namespace tetsculpt
