#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "io/point_file.h"
#include "io/text_scanner.h"

namespace tetsculpt {

/// The cells in what is left of a line, up to `most`.
std::size_t count_cells(TextScanner line, std::size_t most);

/// Rows of a text as points: three columns are x, y and z, others are attributes if they can be.
///   (1) A column becomes an attribute if every row has a number in it; otherwise it is left out.
///   (2) Attributes are doubles, but red, green, blue and alpha are uint8, or uint16, if all their
///       values are whole numbers of that range, and not all of them 0 or 1, which are shares.
class PointRows {
 public:
  /// The columns by their names, x, y and z among them; an empty name is a column to leave out.
  /// Further columns are left out.
  explicit PointRows(std::vector<std::string> names);

  void reserve(std::size_t rows);
  std::size_t size() const { return file_.points.size(); }

  /// Takes a row off the line, and leaves what the columns do not ask for.
  /// Throws IoError with the line if a coordinate is not a number, or a number is out of range.
  void take(TextScanner& in);

  PointFile finish() &&;

 private:
  enum class Use { kX, kY, kZ, kAttribute, kNothing };

  struct Column {
    Use use;
    std::string name;
    std::vector<double> values;  // of an attribute
  };

  void drop(Column& column);

  std::vector<Column> columns_;  // the last one is of use
  std::size_t coordinates_end_ = 0;
  PointFile file_;
};

}  // namespace tetsculpt
