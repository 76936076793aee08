#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "io/attribute.h"
#include "io/number_type.h"
#include "io/text_scanner.h"
#include "kernel/point.h"

namespace tetsculpt {

/// The shape of an array of a legacy VTK file.
struct VtkArray {
  std::optional<NumberType> type;  ///< empty: bits, eight in a byte of a binary file
  std::uint64_t tuples = 0;
  std::uint64_t components = 1;
};

/// A cursor over the lines and arrays of a legacy VTK file, ascii or binary (big endian).
/// Faults are thrown as IoError with the line, or the byte once binary data has been passed.
class VtkScanner {
 public:
  VtkScanner(std::string_view content, const std::filesystem::path& path);
  VtkScanner(const VtkScanner&) = delete;
  VtkScanner& operator=(const VtkScanner&) = delete;

  /// Goes to the next line that is not blank; false if there is none.
  bool next_line() { return in_.next_content_line(); }
  /// The line; it ends before the data of an array.
  TextScanner& line() { return in_; }
  /// The next line, or the data behind this one, begins with `word`.
  bool next_begins_with(std::string_view word) const;

  bool binary() const { return binary_; }

  /// Takes the name of a type off the line.
  std::optional<NumberType> type();

  /// The numbers of an array; throws if the file has no room for them.
  std::uint64_t checked_numbers(const VtkArray& array) const;

  /// Each takes the data behind the line.
  void skip(const VtkArray& array);
  std::vector<Point3> points(const VtkArray& array);            ///< 3 components, no bits
  std::vector<AttributeValues> columns(const VtkArray& array);  ///< one per component, no bits
  void skip_block();                                            ///< up to a blank line

 private:
  const char* bytes_of(const VtkArray& array);
  void find_token();

  std::string_view content_;
  TextDialect dialect_;
  TextScanner in_;
  bool binary_ = false;
};

}  // namespace tetsculpt
