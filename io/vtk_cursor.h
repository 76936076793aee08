#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "io/number_type.h"
#include "io/word_cursor.h"

namespace tetsculpt {

/// A cursor over the words and the values of a legacy VTK file. Values are words too in an ascii
/// file, and big endian numbers in a binary one. Faults are thrown as IoError with the line, or the
/// byte in a binary file. Refers to content and path, which must outlive it.
class VtkCursor {
 public:
  VtkCursor(std::string_view content, const std::filesystem::path& path)
      : content_(content), path_(path), words_(content, path, {}) {}

  void set_binary() { binary_ = true; }
  bool at_end() { return words_.peek().empty(); }

  std::string_view line() { return words_.rest_of_line(); }
  std::string_view word() { return words_.word(); }
  std::string_view peek() { return words_.peek(); }
  /// Takes a word, which must be `expected`.
  void expect(std::string_view expected);
  /// Takes a number of things.
  std::uint64_t count();
  /// Takes the name of a type.
  NumberType type();

  /// Begins `count` values, behind the line on which their type stands: as many can be in what is
  /// left of the file.
  void begin_values(std::uint64_t count, NumberType type);
  double number(NumberType type);
  /// Precondition: the type is one of integers.
  std::int64_t integer(NumberType type);
  void skip_values(std::uint64_t count, NumberType type);

  [[noreturn]] void fail(std::string_view reason) const;

 private:
  template <typename Number>
  Number load();

  std::string_view content_;
  const std::filesystem::path& path_;
  WordCursor words_;
  bool binary_ = false;
  std::size_t latest_ = 0;  // where the latest value begins
};

}  // namespace tetsculpt
