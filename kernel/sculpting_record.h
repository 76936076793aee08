#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// How a surface came about, step by step, told by its triangles alone.
namespace tetsculpt {

struct SculptingRecord {
  static constexpr std::uint32_t kNever = 0xffffffffu;

  /// All triangles that are ever on the surface, as vertex indices, counterclockwise from outside.
  /// One that comes back is listed once per stay.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Per triangle: it is on the surface after step s where born <= s < died. Before step 1, the
  /// first one, s is 0; what is there at the end has died == kNever.
  std::vector<std::uint32_t> born;
  std::vector<std::uint32_t> died;
  std::uint32_t step_count = 0;
};

/// The surface after a step, from 0 to step_count, in the order of the record.
std::vector<std::array<std::uint32_t, 3>> surface_after(const SculptingRecord& record,
                                                        std::uint32_t step);

/// The same with several steps taken as one, a power of two of them and no more than needed for at
/// most `most_triangles` triangles, or for a single step if even that is too many. Every surface it
/// shows is one of `record`, and the first and the last one are the same.
/// Cost: linear, times the logarithm of the steps.
SculptingRecord coarsened(const SculptingRecord& record, std::size_t most_triangles);

/// The first violation of what SculptingRecord promises, indices of `vertex_count` vertices
/// included.
std::optional<std::string> broken_invariant(const SculptingRecord& record,
                                            std::size_t vertex_count);

}  // namespace tetsculpt
