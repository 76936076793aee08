#pragma once

#include <bit>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

/// Numbers as bytes in a given order, the same on every host.
namespace tetsculpt {

static_assert(CHAR_BIT == 8);
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559);

template <std::size_t kBytes>
using BitsOfSize = std::conditional_t<
    kBytes == 1, std::uint8_t,
    std::conditional_t<kBytes == 2, std::uint16_t,
                       std::conditional_t<kBytes == 4, std::uint32_t, std::uint64_t>>>;

/// `value` with its bytes in reverse.
template <typename Number>
Number reversed_bytes(Number value) {
  using Bits = BitsOfSize<sizeof(Number)>;
  auto from = static_cast<std::uint64_t>(std::bit_cast<Bits>(value));
  std::uint64_t to = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i, from >>= 8) to = to << 8 | (from & 0xff);
  return std::bit_cast<Number>(static_cast<Bits>(to));
}

/// The number whose bytes in `order` stand at `from`; no alignment is asked for.
template <typename Number>
Number load_number(const char* from, std::endian order) {
  Number value;
  std::memcpy(&value, from, sizeof value);
  return order == std::endian::native ? value : reversed_bytes(value);
}

/// Puts the bytes of `value` at `to` in `order`; returns the end of what it wrote.
template <typename Number>
char* store_number(char* to, Number value, std::endian order) {
  if (order != std::endian::native) value = reversed_bytes(value);
  std::memcpy(to, &value, sizeof value);
  return to + sizeof value;
}

template <typename Number>
char* store_little_endian(char* to, Number value) {
  return store_number(to, value, std::endian::little);
}

}  // namespace tetsculpt
