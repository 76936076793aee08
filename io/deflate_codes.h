#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/bit_writer.h"
#include "io/repeats.h"

/// The codes in which a deflate block tells its steps.  [RFC 1951, sec. 3.2.5 to 3.2.7]
namespace tetsculpt {

/// A prefix code: how long each symbol's word is, and the word.
struct PrefixCode {
  PrefixCode() = default;
  explicit PrefixCode(std::vector<std::uint8_t> of_lengths);
  void put(BitWriter& to, std::size_t symbol) const { to.put(words[symbol], lengths[symbol]); }

  std::vector<std::uint8_t> lengths;
  std::vector<std::uint16_t> words;
};

/// How often each symbol occurs in a block, its end included.
struct SymbolCounts {
  explicit SymbolCounts(std::span<const RepeatStep> steps);

  std::vector<std::uint32_t> literals;   ///< bytes, the end, and lengths of repeats
  std::vector<std::uint32_t> distances;  ///< of repeats
  std::size_t rest_bits = 0;             ///< that follow symbols which stand for a range
};

/// The two codes of a block.
struct BlockCode {
  /// The one that needs no telling.
  static BlockCode fixed();
  /// The best for a block with these counts.
  static BlockCode made_for(const SymbolCounts& counts);

  /// The block's steps and its end. Precondition: the code has a word for each symbol of theirs.
  void put_steps(BitWriter& to, std::span<const RepeatStep> steps) const;
  /// How many bits put_steps puts.
  std::size_t bits(const SymbolCounts& counts) const;

  PrefixCode literals;
  PrefixCode distances;
};

/// A code as it stands before a block that uses it.
class ToldCode {
 public:
  explicit ToldCode(const BlockCode& code);
  void put(BitWriter& to) const;
  std::size_t bits() const;

 private:
  struct Step {
    std::uint8_t symbol;
    std::uint8_t rest = 0;
  };
  static std::vector<Step> steps_of(std::span<const std::uint8_t> lengths);

  std::size_t literal_count_;
  std::size_t distance_count_;
  std::vector<Step> steps_;
  PrefixCode step_code_;
  std::vector<std::uint8_t> step_lengths_;  // in the order of the stream
};

}  // namespace tetsculpt
