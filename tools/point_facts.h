#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/point_file.h"
#include "kernel/box.h"
#include "sculpt/reconstruct.h"

/// What `info` and --dry-run say of a file of points.
namespace tetsculpt::cli {

/// The least, the quartiles and the largest.
using Quartiles = std::array<double, 5>;

struct PointFacts {
  std::string file;
  std::string format;
  Precision precision = Precision::kDouble;
  std::size_t points = 0;
  std::size_t invalid = 0;
  std::size_t distinct = 0;
  Span span = Span::kNothing;
  Box box;                           ///< of the valid points
  std::optional<Quartiles> spacing;  ///< distances of the distinct points to their nearest others
  std::vector<std::pair<std::string, std::string_view>> attributes;  ///< names and types

  std::size_t duplicates() const { return points - invalid - distinct; }
};

enum class Spacing { kLeftOut, kMeasured };

/// Facts of a file that had so many `invalid` points more. `name` is what messages call it.
/// Throws InvalidPoint and std::length_error, as reconstruct does.
PointFacts point_facts(const PointFile& file, const std::filesystem::path& name,
                       std::size_t invalid, Spacing spacing);

/// For people, some lines.
std::string facts_text(const PointFacts& facts);
std::string facts_json(const PointFacts& facts);

}  // namespace tetsculpt::cli
