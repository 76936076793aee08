#include "io/point_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

namespace tetsculpt {
namespace {

bool is_colour(const Attribute& attribute) {
  return attribute.name == "red" || attribute.name == "green" || attribute.name == "blue" ||
         attribute.name == "alpha";
}

template <typename Integer>
void narrow(Attribute& attribute) {
  const auto& values = std::get<std::vector<double>>(attribute.values);
  std::vector<Integer> narrowed;
  narrowed.reserve(values.size());
  for (const double value : values) narrowed.push_back(static_cast<Integer>(value));
  attribute.values = std::move(narrowed);
}

// All colours together, as they share one scale.
void narrow_colours(std::vector<Attribute>& attributes) {
  double highest = 0;
  for (const Attribute& attribute : attributes) {
    if (!is_colour(attribute)) continue;
    for (const double value : std::get<std::vector<double>>(attribute.values)) {
      if (!(value >= 0 && value <= UINT16_MAX) || value != std::floor(value)) return;
      highest = std::max(highest, value);
    }
  }
  if (highest <= 1) return;
  for (Attribute& attribute : attributes) {
    if (!is_colour(attribute)) continue;
    if (highest <= UINT8_MAX) {
      narrow<std::uint8_t>(attribute);
    } else {
      narrow<std::uint16_t>(attribute);
    }
  }
}

}  // namespace

std::size_t count_cells(TextScanner line, std::size_t most) {
  std::size_t count = 0;
  for (; count < most && !line.at_line_end(); ++count) {
    line.token();
    line.next_cell();
  }
  return count;
}

PointRows::PointRows(std::vector<std::string> names) {
  for (std::string& name : names) {
    Use use = name.empty() ? Use::kNothing : Use::kAttribute;
    if (name == "x") use = Use::kX;
    if (name == "y") use = Use::kY;
    if (name == "z") use = Use::kZ;
    columns_.push_back({use, std::move(name), {}});
    if (use <= Use::kZ) coordinates_end_ = columns_.size();
  }
  while (columns_.back().use == Use::kNothing) columns_.pop_back();
}

void PointRows::reserve(std::size_t rows) {
  file_.points.reserve(rows);
  for (Column& column : columns_) {
    if (column.use == Use::kAttribute) column.values.reserve(rows);
  }
}

void PointRows::take(TextScanner& in) {
  std::array<double, 3> xyz{};
  bool comma_alone = false;
  bool no_comma = false;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string_view border = i > 0 ? in.next_cell() : std::string_view();
    if (i > 0 && i < coordinates_end_) {
      comma_alone |= border == ",";
      no_comma |= border.find(',') == std::string_view::npos;
    }
    Column& column = columns_[i];
    if (column.use <= Use::kZ) {
      xyz[static_cast<std::size_t>(column.use)] = in.number<double>();
    } else if (column.use == Use::kNothing) {
      in.token();
    } else if (const auto value = in.number_if_any()) {
      column.values.push_back(*value);
    } else {
      drop(column);
      in.token();
    }
  }
  // 1,5;2,5;3,5 would be read as 1, 5, 2.
  if (comma_alone && no_comma) {
    in.fail("commas and other separators between coordinates: write decimal points, not commas");
  }
  while (columns_.back().use == Use::kNothing) columns_.pop_back();
  file_.points.push_back({xyz[0], xyz[1], xyz[2]});
}

void PointRows::drop(Column& column) {
  column.use = Use::kNothing;
  column.values = {};
}

PointFile PointRows::finish() && {
  for (Column& column : columns_) {
    if (column.use != Use::kAttribute) continue;
    file_.attributes.push_back({std::move(column.name), std::move(column.values)});
  }
  narrow_colours(file_.attributes);
  return std::move(file_);
}

}  // namespace tetsculpt
