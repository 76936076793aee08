#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Prefix codes as deflate has them.  [RFC 1951, sec. 3.2.2]
namespace tetsculpt {

/// The length in bits of each symbol's code, at most `limit`; 0 for a symbol that does not occur.
///   (1) Two or more symbols that occur: the code is complete (no bit string is left over).
///   (2) One: its length is 1. None: all zero.
///   (3) No other code is shorter in sum, unless the limit binds.
/// Precondition: 2^limit is at least twice the number of symbols that occur, their sum is < 2^32.
std::vector<std::uint8_t> code_lengths(std::span<const std::uint32_t> counts, int limit);

/// The canonical codes of these lengths, first bit lowest, as they go into the stream.
std::vector<std::uint16_t> canonical_codes(std::span<const std::uint8_t> lengths);

}  // namespace tetsculpt
