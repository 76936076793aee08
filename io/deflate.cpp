// Deflate: runs of steps (io/repeats.h) become blocks, each in the cheapest of the three forms that
// RFC 1951 knows: the bytes as they are, the fixed code, or a code made for the block.
#include "io/deflate.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "io/bit_writer.h"
#include "io/deflate_codes.h"
#include "io/repeats.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kStepsPerBlock = 32768;
enum Form : std::uint32_t { kStored = 0, kFixedCode = 1, kOwnCode = 2 };

std::size_t size_of(std::span<const RepeatStep> steps) {
  std::size_t size = 0;
  for (const RepeatStep& step : steps) size += step.length == 0 ? 1 : step.length;
  return size;
}

void begin_block(BitWriter& to, bool last, Form form) {
  to.put(last ? 1 : 0, 1);
  to.put(form, 2);
}

void put_stored(BitWriter& to, std::string_view bytes, bool last) {
  constexpr std::size_t kMost = std::numeric_limits<std::uint16_t>::max();
  do {
    const std::string_view piece = bytes.substr(0, kMost);
    bytes.remove_prefix(piece.size());
    begin_block(to, last && bytes.empty(), kStored);
    to.end_byte();
    const auto size = static_cast<std::uint32_t>(piece.size());
    to.put(size, 16);
    to.put(size ^ 0xffff, 16);
    to.append(piece);
  } while (!bytes.empty());
}

/// Precondition: `steps` tell `bytes`.
void put_block(BitWriter& to, std::span<const RepeatStep> steps, std::string_view bytes,
               bool last) {
  const SymbolCounts counts(steps);
  const BlockCode fixed = BlockCode::fixed();
  const BlockCode own = BlockCode::made_for(counts);
  const ToldCode told(own);
  const std::size_t fixed_bits = fixed.bits(counts);
  const std::size_t own_bits = told.bits() + own.bits(counts);
  if (8 * bytes.size() + 32 < std::min(fixed_bits, own_bits)) {
    put_stored(to, bytes, last);
  } else if (fixed_bits <= own_bits) {
    begin_block(to, last, kFixedCode);
    fixed.put_steps(to, steps);
  } else {
    begin_block(to, last, kOwnCode);
    told.put(to);
    own.put_steps(to, steps);
  }
}

std::uint32_t adler32(std::string_view bytes) {
  constexpr std::uint32_t kPrime = 65521;
  constexpr std::size_t kNoOverflow = 5552;  // so many sums stay below 2^32
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  while (!bytes.empty()) {
    const std::string_view piece = bytes.substr(0, kNoOverflow);
    bytes.remove_prefix(piece.size());
    for (const char byte : piece) b += a += static_cast<std::uint8_t>(byte);
    a %= kPrime;
    b %= kPrime;
  }
  return b << 16 | a;
}

}  // namespace

std::string zlib_stream(std::string_view bytes) {
  BitWriter out;
  out.append("\x78\x9c");  // deflate, a window of 32768 bytes, no dictionary
  const std::vector<RepeatStep> all_steps = find_repeats(bytes);
  std::span<const RepeatStep> steps = all_steps;
  std::string_view rest = bytes;
  do {
    const auto of_block = steps.first(std::min(steps.size(), kStepsPerBlock));
    steps = steps.subspan(of_block.size());
    const std::size_t size = size_of(of_block);
    put_block(out, of_block, rest.substr(0, size), steps.empty());
    rest.remove_prefix(size);
  } while (!steps.empty());
  out.end_byte();
  const std::uint32_t sum = adler32(bytes);
  for (const int shift : {24, 16, 8, 0}) out.put(sum >> shift & 0xff, 8);
  return std::move(out).take();
}

}  // namespace tetsculpt
