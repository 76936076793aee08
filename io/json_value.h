#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tetsculpt {

struct JsonMember;

/// A value of a JSON text.
struct JsonValue {
  using List = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;  ///< in ascending order of the names, which differ

  std::variant<std::nullptr_t, bool, double, std::string, List, Object> value;  ///< null at first
  std::size_t offset = 0;  ///< of its first byte in the text

  /// What it is if it is of that type, else null.
  template <typename Type>
  const Type* as() const {
    return std::get_if<Type>(&value);
  }
  /// The member with this name; null if there is none, or the value is no object.
  const JsonValue* member(std::string_view name) const;
};

struct JsonMember {
  std::string name;
  JsonValue value;
};

/// A text that is not JSON; what() says why.
class JsonError : public std::runtime_error {
 public:
  JsonError(std::size_t offset, const std::string& reason)
      : std::runtime_error(reason), offset_(offset) {}
  std::size_t offset() const { return offset_; }

 private:
  std::size_t offset_;
};

/// The value that a text is, strictly: no comments, no commas too many, nothing behind it.
///   (1) Numbers are the nearest doubles.   (2) Texts are UTF-8, their escapes resolved.
/// Throws JsonError; also for names that an object has twice, numbers beyond the doubles, halves of
/// surrogate pairs, and values nested deeper than 200.  Cost: linear, but for sorting names.
/// [RFC 8259]
JsonValue parse_json(std::string_view text);

}  // namespace tetsculpt
