#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/attribute.h"
#include "io/byte_order.h"
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

/// The cells of a section, in one of two layouts: `second` integers, the corners of each cell
/// behind their number; or, since version 5, `first` offsets and then `second` corners.
struct VtkCells {
  std::uint64_t first = 0;  ///< cells, or offsets: one more
  std::uint64_t second = 0;
  bool has_offsets = false;
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
  /// The same of integers, one after the other: calls use(value), at the place of the value.
  template <typename Use>
  void each_integer(const VtkArray& array, Use use);
  void skip_block();  ///< up to a blank line

  /// Takes the numbers off the line of a section of cells, and the line OFFSETS.
  VtkCells cells();
  /// Goes to the line CONNECTIVITY and takes its type off.
  std::optional<NumberType> connectivity();
  void skip_cells();
  /// The arrays of a FIELD, whose line this is: calls use(name, array), which takes the data.
  template <typename Use>
  void fields(Use use);

 private:
  const char* bytes_of(const VtkArray& array);
  void find_token();
  void find_field_array();

  std::string_view content_;
  TextDialect dialect_;
  TextScanner in_;
  bool binary_ = false;
};

template <typename Use>
void VtkScanner::each_integer(const VtkArray& array, Use use) {
  if (!array.type || *array.type >= NumberType::kFloat32) in_.fail("indices must be integers");
  const std::uint64_t numbers = checked_numbers(array);
  with_type(*array.type, [&]<typename Number>(std::type_identity<Number>) {
    for (std::uint64_t left = numbers; left > 0; --left) {
      if (binary_) {
        const char* const bytes = in_.take_bytes(sizeof(Number)).data();
        use(static_cast<std::int64_t>(load_number<Number>(bytes, std::endian::big)));
      } else {
        find_token();
        use(in_.integer());
      }
    }
  });
}

template <typename Use>
void VtkScanner::fields(Use use) {
  in_.token();  // the name of all
  for (std::uint64_t left = in_.count(); left > 0; --left) {
    find_field_array();
    const std::string name(in_.token());
    const std::uint64_t components = in_.count();
    const std::uint64_t tuples = in_.count();
    use(name, VtkArray{type(), tuples, components});
  }
}

}  // namespace tetsculpt
