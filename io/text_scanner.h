#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "kernel/point.h"

namespace tetsculpt {

struct TextDialect {
  std::string_view separators = " \t";                   ///< between tokens, in any number
  std::string_view delimiters = "";                      ///< the same, one at a time: next_cell()
  std::array<std::string_view, 2> comments = {"#", ""};  ///< their starts; "" is none
};

/// A cursor over the lines of a text and the tokens of a line. A line ends with LF, CRLF, CR or
/// the text; a UTF-8 byte order mark is skipped. Faults are thrown as IoError with path and line.
/// Holds references: text, path and dialect must outlive it.
class TextScanner {
 public:
  TextScanner(std::string_view text, const std::filesystem::path& path, const TextDialect& dialect);

  /// Goes to the next line; false, and no move, if there is none.
  bool next_line();
  /// The same, over lines that are blank or a comment.
  bool next_content_line();
  /// Where the line after this one begins.
  std::size_t next_offset() const { return next_; }
  std::size_t bytes_left() const { return text_.size() - next_; }

  /// The `size` bytes behind the line, which have to be there; the cursor is then behind them, and
  /// faults have a byte for a place, not a line.
  std::string_view take_bytes(std::size_t size);

  /// Nothing but separators, or a comment, is left of the line.
  bool at_line_end();
  bool at_delimiter();
  /// The next token is a number of the kind that number() takes.
  bool at_number();

  /// Each takes one token off the line.
  /// Empty at the end of the line and at a delimiter. Where there are delimiters, "quoted, text" is
  /// one token.
  std::string_view token();
  template <typename Float>
  Float number();  ///< float or double; throws if there is none or it is too large
  std::optional<double> number_if_any();  ///< stays if there is none; throws if it is too large
  std::uint64_t count();                  ///< decimal digits only; throws on anything else
  std::int64_t integer();                 ///< the same, perhaps with a minus sign
  Point3 point();                         ///< three numbers
  /// Goes over separators and at most one delimiter; what it went over.
  std::string_view next_cell();
  /// Takes `word` off the line if the line goes on with it.
  bool accept(std::string_view word);

  std::string_view rest_of_line() const { return rest_; }
  std::uint64_t line_number() const { return line_number_; }
  [[noreturn]] void fail(std::string_view reason) const;

 private:
  enum class Kind : std::uint8_t { kOfToken, kSeparator, kDelimiter };

  Kind kind(char c) const { return kinds_[static_cast<unsigned char>(c)]; }
  void skip_separators();
  template <typename Float>
  std::optional<Float> number_or_nothing();
  template <typename Integer>
  Integer whole_number(std::string_view expected);
  [[noreturn]] void fail_at_token(std::string_view reason);

  std::string_view text_;
  const std::filesystem::path& path_;
  const TextDialect& dialect_;
  std::array<Kind, 256> kinds_{};
  std::size_t next_ = 0;       // begin of the next line
  std::size_t line_feed_ = 0;  // first LF at or after next_, once it has been looked for
  std::uint64_t line_number_ = 0;
  bool behind_bytes_ = false;
  std::string_view rest_;  // of the line
};

}  // namespace tetsculpt
