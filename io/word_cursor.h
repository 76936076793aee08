#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "kernel/point.h"

namespace tetsculpt {

struct WordDialect {
  std::string_view separators = " \t\r\n";  ///< between words, in any number
  std::string_view marks = "";              ///< characters that are words by themselves
  char comment = '\0';                      ///< from here to the end of the line; '\0' is none
};

/// A cursor over the words of a text in which lines mean nothing. A text in double quotes is one
/// word if '"' is a mark. Faults are thrown as IoError with path and line.
/// Refers to text and path, which must outlive it.
class WordCursor {
 public:
  WordCursor(std::string_view text, const std::filesystem::path& path, const WordDialect& dialect);

  /// Takes a word; empty at the end of the text.
  std::string_view word();
  /// The word that word() would take.
  std::string_view peek();
  /// Each takes one word, which must be of that kind.
  double number();
  std::int64_t integer();
  Point3 point();  ///< three numbers

  /// The line of the fault is that of the latest word.
  [[noreturn]] void fail(std::string_view reason) const;

 private:
  bool is_separator(char c) const { return kind_[static_cast<unsigned char>(c)] == 1; }
  bool is_mark(char c) const { return kind_[static_cast<unsigned char>(c)] == 2; }
  void skip_separators();
  [[noreturn]] void fail_at(std::string_view expected, std::string_view word) const;

  std::string_view text_;
  const std::filesystem::path* path_;
  std::array<unsigned char, 256> kind_{};  // 0: of a word, 1: separator, 2: mark
  char comment_;
  std::size_t at_ = 0;
  std::size_t latest_ = 0;  // where the latest word begins
};

}  // namespace tetsculpt
