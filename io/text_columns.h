#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/text_scanner.h"

namespace tetsculpt {

/// What a text without names of columns means by its further columns.
enum class TextColumns {
  kUnknown,
  kPts,  ///< of 4, 6 and 7 columns: intensity; red green blue; intensity red green blue
};

/// The names of the columns of a text, from what stands before its first row.
class TextColumnNames {
 public:
  explicit TextColumnNames(TextColumns usual) : usual_(usual) {}

  /// A comment names columns if x, y and z are among its words.
  void take_comment(std::string_view line);
  /// A line of titles.
  void take_titles(std::string_view line);

  /// The names of all columns of the row on which `in` stands, x, y and z among them.
  ///   (1) Titles with x, y and z name the columns, in any order; a comment the same, if it has
  ///       a word for each column.
  ///   (2) Otherwise the first three are x, y and z; titles, if there is one for each column, name
  ///       the others. (3) A column without a name is scalar_N, N its place from 1.
  /// Throws IoError with the line if blanks in titles leave it open which column is which, and if
  /// there are more columns than anyone could mean.
  std::vector<std::string> of_row(const TextScanner& in) const;

 private:
  struct Titles {
    std::vector<std::string> names;
    bool delimited = false;  // each by a comma, semicolon or tab, so that no blank can mislead
  };

  static Titles split(std::string_view line);

  TextColumns usual_;
  Titles titles_;
  Titles comment_;
};

}  // namespace tetsculpt
