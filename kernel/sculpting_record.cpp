#include "kernel/sculpting_record.h"

#include <algorithm>

namespace tetsculpt {
namespace {

/// The first of the joined steps, 2^shift each, that ends with or after `step`.
std::uint32_t joined_step(std::uint32_t step, int shift) {
  if (step == SculptingRecord::kNever) return step;
  const std::uint64_t last_of_one = (std::uint64_t{1} << shift) - 1;
  return static_cast<std::uint32_t>((step + last_of_one) >> shift);
}

/// Does the triangle's stay hold the end of a joined step?
bool seen(const SculptingRecord& record, std::size_t triangle, int shift) {
  return joined_step(record.born[triangle], shift) < joined_step(record.died[triangle], shift);
}

std::size_t seen_count(const SculptingRecord& record, int shift) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < record.triangles.size(); ++i) n += seen(record, i, shift) ? 1u : 0u;
  return n;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> surface_after(const SculptingRecord& record,
                                                        std::uint32_t step) {
  std::vector<std::array<std::uint32_t, 3>> surface;
  for (std::size_t i = 0; i < record.triangles.size(); ++i) {
    if (record.born[i] <= step && step < record.died[i]) surface.push_back(record.triangles[i]);
  }
  return surface;
}

SculptingRecord coarsened(const SculptingRecord& record, std::size_t most_triangles) {
  int shift = 0;
  while (joined_step(record.step_count, shift) > 1 && seen_count(record, shift) > most_triangles) {
    ++shift;
  }
  SculptingRecord joined;
  joined.step_count = joined_step(record.step_count, shift);
  for (std::size_t i = 0; i < record.triangles.size(); ++i) {
    if (!seen(record, i, shift)) continue;
    joined.triangles.push_back(record.triangles[i]);
    joined.born.push_back(joined_step(record.born[i], shift));
    joined.died.push_back(joined_step(record.died[i], shift));
  }
  return joined;
}

std::optional<std::string> broken_invariant(const SculptingRecord& record,
                                            std::size_t vertex_count) {
  if (record.born.size() != record.triangles.size() ||
      record.died.size() != record.triangles.size()) {
    return "the arrays differ in size";
  }
  for (std::size_t i = 0; i < record.triangles.size(); ++i) {
    const std::string name = "triangle " + std::to_string(i);
    if (std::ranges::any_of(record.triangles[i], [&](auto v) { return v >= vertex_count; })) {
      return name + " has a corner that is no vertex";
    }
    if (record.born[i] >= record.died[i]) return name + " is never there";
    if (record.born[i] > record.step_count) return name + " comes after the last step";
    if (record.died[i] > record.step_count && record.died[i] != SculptingRecord::kNever) {
      return name + " goes after the last step";
    }
  }
  return std::nullopt;
}

}  // namespace tetsculpt
