#include "io/parse_number.h"

#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <system_error>

namespace tetsculpt {
namespace {

// std::from_chars reports numbers beyond the range without telling which end, and some libraries
// count denormals among them. The stream gives all of them a rounded value; it is slow but rare.
template <typename Float>
ParsedNumber<Float> parse_extreme(const char* begin, const char* end) {
  std::istringstream stream(std::string(begin, end));
  stream.imbue(std::locale::classic());
  Float value = 0;
  stream >> value;
  const bool too_large = std::abs(value) >= 1;
  return {value, end, too_large ? NumberFault::kTooLarge : NumberFault::kNone};
}

}  // namespace

template <typename Float>
ParsedNumber<Float> parse_number(std::string_view text) {
  const char* begin = text.data();
  const char* const end = begin + text.size();
  if (begin != end && *begin == '+') {
    ++begin;
    if (begin != end && *begin == '-') return {0, begin, NumberFault::kNotANumber};
  }
  Float value = 0;
  const auto [after, error] = std::from_chars(begin, end, value);
  if (error == std::errc()) return {value, after, NumberFault::kNone};
  if (error == std::errc::result_out_of_range) return parse_extreme<Float>(begin, after);
  return {0, after, NumberFault::kNotANumber};
}

template ParsedNumber<float> parse_number<float>(std::string_view text);
template ParsedNumber<double> parse_number<double>(std::string_view text);

}  // namespace tetsculpt
