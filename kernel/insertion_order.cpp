// N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", SoCG 2003.
#include "kernel/insertion_order.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>

#include "kernel/split_mix.h"

namespace tetsculpt {
namespace {

// A round of q times all before it streams the facets through the cache 1 / q times less often, but
// its cavities grow along the curve; 1 to 4 bits measured, on volumes and surfaces.
constexpr int kBitsPerRound = 3;         // a round is 2^3 - 1 times as large as all before it
constexpr std::size_t kFirstRound = 64;  // at most about so many points in the first round

}  // namespace

InsertionOrder insertion_order(std::size_t vertex_count) {
  InsertionOrder result;
  if (vertex_count == 0) return result;
  std::size_t last_round = 0;
  while (vertex_count >> (kBitsPerRound * last_round) > kFirstRound) ++last_round;
  const auto round_of = [&](std::size_t v) {
    const auto coins = static_cast<std::size_t>(std::countr_zero(split_mix(v)));
    return last_round - std::min(coins / kBitsPerRound, last_round);
  };
  result.round_begin.assign(last_round + 2, 0);
  for (std::size_t v = 0; v < vertex_count; ++v) ++result.round_begin[round_of(v) + 1];
  std::partial_sum(result.round_begin.begin(), result.round_begin.end(),
                   result.round_begin.begin());
  result.vertices.resize(vertex_count);
  std::vector<std::size_t> next = result.round_begin;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    result.vertices[next[round_of(v)]++] = VertexId{static_cast<std::uint32_t>(v)};
  }
  return result;
}

}  // namespace tetsculpt
