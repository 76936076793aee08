#pragma once

#include <bit>
#include <cstddef>
#include <type_traits>

#include "io/attribute.h"
#include "io/number_type.h"
#include "io/text_scanner.h"

/// Values of attributes as readers collect them, one by one.
namespace tetsculpt {

/// What a number of the type is kept as: 64-bit integers become doubles, the nearest ones.
template <typename Number>
using AttributeValue =
    std::conditional_t<std::is_integral_v<Number> && sizeof(Number) == 8, double, Number>;

/// No values, and room for some.
AttributeValues empty_values(NumberType type, std::size_t capacity);

/// Appends the number of type `type` whose bytes stand at `from`.
/// Precondition: `values` is for that type.
void append_number(AttributeValues& values, NumberType type, const char* from, std::endian order);

/// Takes a number off the line and appends it. Throws IoError with the line if there is none or if
/// the type of the values cannot hold it.
void append_number(AttributeValues& values, TextScanner& in);

}  // namespace tetsculpt
