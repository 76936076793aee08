#pragma once

#include <string_view>

namespace tetsculpt {

enum class NumberFault {
  kNone,
  kNotANumber,
  kTooLarge,  ///< rounds to more than the largest finite value
};

template <typename Float>
struct ParsedNumber {
  Float value;
  const char* end;  ///< first character after the number
  NumberFault fault;
};

/// Reads the decimal number with which `text` begins, with or without a sign.
///   (1) The value is the nearest of its type, ties to even; what is too small becomes a denormal
///       or a zero of its sign.   (2) "inf" and "nan" in any case are numbers.
///   (3) The locale has no influence.
/// Float is float or double. `value` counts only if there is no fault.
template <typename Float>
ParsedNumber<Float> parse_number(std::string_view text);

}  // namespace tetsculpt
