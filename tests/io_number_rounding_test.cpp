// Decimal numbers become the nearest float or double, whatever their size and the locale.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <locale>
#include <string>
#include <string_view>

#include "io/parse_number.h"
#include "tests/support/io_hard_points.h"

namespace tetsculpt {
namespace {

using testing::same_bits;

template <typename Float>
Float value_of(std::string_view text) {
  const auto parsed = parse_number<Float>(text);
  CHECK(parsed.fault == NumberFault::kNone);
  CHECK(parsed.end == text.data() + text.size());
  return parsed.value;
}

template <typename Float>
NumberFault fault_of(std::string_view text) {
  return parse_number<Float>(text).fault;
}

TEST_CASE("signs and forms") {
  CHECK(value_of<double>("+1.5") == 1.5);
  CHECK(value_of<double>("-.5e1") == -5);
  CHECK(value_of<double>("5.") == 5);
  CHECK(value_of<double>("1E+2") == 100);
  CHECK(same_bits(value_of<double>("-0"), -0.0));
  CHECK(same_bits(value_of<double>("+0"), 0.0));
  for (const char* text : {"", "+", "-", "+-1", "++1", "-+1", ".", "e5", "x"}) {
    CAPTURE(text);
    CHECK(fault_of<double>(text) == NumberFault::kNotANumber);
  }
}

TEST_CASE("not finite") {
  CHECK(std::isnan(value_of<double>("nan")));
  CHECK(std::isnan(value_of<double>("-NaN")));
  CHECK(value_of<double>("inf") == std::numeric_limits<double>::infinity());
  CHECK(value_of<double>("-Inf") == -std::numeric_limits<double>::infinity());
  CHECK(value_of<float>("+infinity") == std::numeric_limits<float>::infinity());
}

TEST_CASE("ties go to even, and one digit far behind decides") {
  CHECK(value_of<double>("9007199254740993") == 9007199254740992.0);
  CHECK(value_of<double>("9007199254740995") == 9007199254740996.0);
  CHECK(value_of<double>("9007199254740993." + std::string(400, '0') + "1") == 9007199254740994.0);
  CHECK(value_of<float>("16777217") == 16777216.0F);
  // As a double first, this would round to the tie and then down.
  CHECK(value_of<float>("16777217.00000000001") == 16777218.0F);
}

TEST_CASE("too large") {
  CHECK(value_of<double>("1.7976931348623158e308") == std::numeric_limits<double>::max());
  for (const char* text : {"1.8e308", "-1e309", "1e400", "1e99999999999999999999"}) {
    CAPTURE(text);
    CHECK(fault_of<double>(text) == NumberFault::kTooLarge);
  }
  CHECK(fault_of<float>("3.5e38") == NumberFault::kTooLarge);
  CHECK(fault_of<double>(std::string(310, '9')) == NumberFault::kTooLarge);
}

TEST_CASE("too small becomes a denormal or a zero of its sign") {
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  CHECK(value_of<double>("4.9406564584124654e-324") == kTiny);
  CHECK(value_of<double>("2.4703282292062328e-324") == kTiny);       // just above a half
  CHECK(same_bits(value_of<double>("2.4703282292062327e-324"), 0));  // just below
  CHECK(value_of<double>("7.4e-324") == kTiny);
  CHECK(value_of<double>("7.5e-324") == 2 * kTiny);
  CHECK(value_of<double>("2.2250738585072011e-308") ==
        std::nextafter(std::numeric_limits<double>::min(), 0));
  CHECK(same_bits(value_of<double>("1e-400"), 0));
  CHECK(same_bits(value_of<double>("-1e-400"), -0.0));
  CHECK(same_bits(value_of<double>("+1e-99999999999999999999"), 0));
  CHECK(value_of<double>("0." + std::string(323, '0') + "99") == 2 * kTiny);
  CHECK(value_of<float>("1e-45") == std::numeric_limits<float>::denorm_min());
  CHECK(value_of<float>("1e-60") == 0);
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '\''; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_CASE("the locale has no influence") {
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  CHECK(value_of<double>("1.5") == 1.5);
  CHECK(value_of<double>("7.5e-324") == 2 * std::numeric_limits<double>::denorm_min());
  CHECK(same_bits(value_of<double>("-0.5e-400"), -0.0));
  CHECK(fault_of<double>("0.5e400") == NumberFault::kTooLarge);
  std::locale::global(before);
}

}  // namespace
}  // namespace tetsculpt
