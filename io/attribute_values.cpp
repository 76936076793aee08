#include "io/attribute_values.h"

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "io/byte_order.h"

namespace tetsculpt {
namespace {

template <typename Integer>
Integer integer(TextScanner& in) {
  constexpr auto kLowest = static_cast<double>(std::numeric_limits<Integer>::lowest());
  constexpr auto kHighest = static_cast<double>(std::numeric_limits<Integer>::max());
  const auto value = in.number<double>();
  if (!(value >= kLowest && value <= kHighest) || value != std::floor(value)) {
    in.fail("expected a whole number from " + std::to_string(std::numeric_limits<Integer>::min()) +
            " to " + std::to_string(std::numeric_limits<Integer>::max()));
  }
  return static_cast<Integer>(value);
}

}  // namespace

AttributeValues empty_values(NumberType type, std::size_t capacity) {
  return with_type(type,
                   [capacity]<typename Number>(std::type_identity<Number>) -> AttributeValues {
                     std::vector<AttributeValue<Number>> values;
                     values.reserve(capacity);
                     return values;
                   });
}

void append_number(AttributeValues& values, NumberType type, const char* from, std::endian order) {
  with_type(type, [&]<typename Number>(std::type_identity<Number>) {
    using Value = AttributeValue<Number>;
    std::get<std::vector<Value>>(values).push_back(
        static_cast<Value>(load_number<Number>(from, order)));
  });
}

void append_number(AttributeValues& values, TextScanner& in) {
  std::visit(
      [&in]<typename Value>(std::vector<Value>& all) {
        if constexpr (std::is_integral_v<Value>) {
          all.push_back(integer<Value>(in));
        } else {
          all.push_back(in.number<Value>());
        }
      },
      values);
}

}  // namespace tetsculpt
