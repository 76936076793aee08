#include "io/vtk_scanner.h"

#include <array>
#include <bit>
#include <string>

#include "io/attribute_values.h"
#include "io/binary_columns.h"
#include "io/vtk_types.h"

namespace tetsculpt {
namespace {

constexpr std::uint64_t kMostComponents = 10'000;
constexpr std::size_t kShortestNumber = 2;  // a digit and what is behind it

}  // namespace

VtkScanner::VtkScanner(std::string_view content, const std::filesystem::path& path)
    : content_(content), dialect_{.comments = {}}, in_(content, path, dialect_) {
  in_.next_line();
  if (!in_.accept("# vtk DataFile Version")) in_.fail("not a legacy VTK file");
  if (!in_.next_line() || !in_.next_content_line()) in_.fail("the file ends within its header");
  const std::string_view format = in_.token();
  binary_ = format == "BINARY";
  if (!binary_ && format != "ASCII") in_.fail("expected ASCII or BINARY");
}

bool VtkScanner::next_begins_with(std::string_view word) const {
  return content_.substr(in_.next_offset()).starts_with(word);
}

std::optional<NumberType> VtkScanner::type() {
  const std::string_view name = in_.token();
  if (name == "bit") return std::nullopt;
  if (const auto type = vtk_type_named(name)) return type;
  in_.fail("arrays of type '" + std::string(name) + "' are not read");
}

std::uint64_t VtkScanner::checked_numbers(const VtkArray& array) const {
  if (array.components == 0 || array.components > kMostComponents) {
    in_.fail("an array of " + std::to_string(array.components) + " components");
  }
  const std::uint64_t left = in_.bytes_left() + (binary_ ? 0 : in_.rest_of_line().size());
  const std::uint64_t room = !binary_     ? left / kShortestNumber + 1
                             : array.type ? left / byte_size(*array.type)
                                          : left * 8;
  if (array.tuples > room / array.components) {
    in_.fail("the file is too short for " + std::to_string(array.tuples) + " times " +
             std::to_string(array.components) + " numbers");
  }
  return array.tuples * array.components;
}

void VtkScanner::find_token() {
  while (in_.at_line_end()) {
    if (!in_.next_line()) in_.fail("the file ends within an array");
  }
}

const char* VtkScanner::bytes_of(const VtkArray& array) {
  const auto numbers = static_cast<std::size_t>(checked_numbers(array));
  return in_.take_bytes(array.type ? numbers * byte_size(*array.type) : (numbers + 7) / 8).data();
}

void VtkScanner::skip(const VtkArray& array) {
  if (binary_) {
    bytes_of(array);
    return;
  }
  for (std::uint64_t left = checked_numbers(array); left > 0; --left) {
    find_token();
    in_.token();
  }
}

std::vector<Point3> VtkScanner::points(const VtkArray& array) {
  const NumberType type = *array.type;
  if (binary_) {
    const std::size_t size = byte_size(type);
    const char* const first = bytes_of(array);
    const std::array<BinaryColumn, 3> xyz = {{{type, first, 3 * size},
                                              {type, first + size, 3 * size},
                                              {type, first + 2 * size, 3 * size}}};
    return points_of(xyz, static_cast<std::size_t>(array.tuples), std::endian::big);
  }
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(checked_numbers(array) / 3));
  while (points.size() < array.tuples) {
    std::array<double, 3> xyz{};
    for (double& value : xyz) {
      find_token();
      value = type == NumberType::kFloat32 ? double{in_.number<float>()} : in_.number<double>();
    }
    points.push_back({xyz[0], xyz[1], xyz[2]});
  }
  return points;
}

std::vector<AttributeValues> VtkScanner::columns(const VtkArray& array) {
  const NumberType type = *array.type;
  const auto components = static_cast<std::size_t>(array.components);
  const auto tuples = static_cast<std::size_t>(array.tuples);
  std::vector<AttributeValues> columns;
  if (binary_) {
    const char* const first = bytes_of(array);
    const std::size_t size = byte_size(type);
    for (std::size_t i = 0; i < components; ++i) {
      const BinaryColumn column{type, first + i * size, components * size};
      columns.push_back(values_of(column, tuples, std::endian::big));
    }
    return columns;
  }
  checked_numbers(array);
  for (std::size_t i = 0; i < components; ++i) columns.push_back(empty_values(type, tuples));
  for (std::size_t i = 0; i < tuples; ++i) {
    for (AttributeValues& values : columns) {
      find_token();
      append_number(values, in_);
    }
  }
  return columns;
}

void VtkScanner::skip_block() {
  while (in_.next_line() && !in_.at_line_end()) {
  }
}

VtkCells VtkScanner::cells() {
  const std::uint64_t first = in_.count();
  const std::uint64_t second = in_.count();
  const bool has_offsets = next_begins_with("OFFSETS");
  if (has_offsets) {
    next_line();
    in_.token();
  }
  return {first, second, has_offsets};
}

std::optional<NumberType> VtkScanner::connectivity() {
  if (!next_line() || in_.token() != "CONNECTIVITY") in_.fail("expected CONNECTIVITY");
  return type();
}

void VtkScanner::skip_cells() {
  const VtkCells of = cells();
  if (!of.has_offsets) return skip({NumberType::kInt32, of.second});
  skip({type(), of.first});
  const std::optional<NumberType> type = connectivity();
  skip({type, of.second});
}

void VtkScanner::find_field_array() {
  const auto next = [this] {
    if (!next_line()) in_.fail("the file ends within a FIELD");
  };
  next();
  if (!in_.accept("METADATA")) return;
  skip_block();
  next();
}

}  // namespace tetsculpt
