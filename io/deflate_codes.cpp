#include "io/deflate_codes.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "io/huffman.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kLiterals = 286;
constexpr std::size_t kDistances = 30;
constexpr int kLongestWord = 15;
constexpr int kLongestStepWord = 7;
constexpr std::array<std::uint8_t, 19> kStepOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                     11, 4,  12, 3, 13, 2, 14, 1, 15};

/// A value as the symbol of a range of values and its place there.
struct Ranged {
  std::size_t symbol;
  std::uint32_t rest;
  int rest_bits;
};

// Ranges of 1, 1, ... values, then two or four ranges of each power of two.  [RFC 1951, sec. 3.2.5]
Ranged ranged(std::size_t value, int ranges_per_power_bits) {
  int bits = 0;
  while ((value >> bits) >= (std::size_t{2} << ranges_per_power_bits)) ++bits;
  const std::size_t symbol =
      (static_cast<std::size_t>(bits) << ranges_per_power_bits) + (value >> bits);
  return {symbol, static_cast<std::uint32_t>(value & ((std::size_t{1} << bits) - 1)), bits};
}

Ranged ranged_length(std::size_t length) {
  if (length == 258) return {285, 0, 0};
  Ranged r = ranged(length - 3, 2);
  r.symbol += kEndOfBlock + 1;
  return r;
}

// Distances: two ranges for each power of two.
Ranged ranged_distance(std::size_t distance) { return ranged(distance - 1, 1); }

std::size_t cost(std::span<const std::uint32_t> counts, std::span<const std::uint8_t> lengths) {
  return std::inner_product(counts.begin(), counts.end(), lengths.begin(), std::size_t{0});
}

std::size_t used(std::span<const std::uint8_t> lengths, std::size_t at_least) {
  std::size_t n = lengths.size();
  while (n > at_least && lengths[n - 1] == 0) --n;
  return n;
}

int rest_bits_of_step(std::uint8_t symbol) {
  return symbol == 16 ? 2 : symbol == 17 ? 3 : symbol == 18 ? 7 : 0;
}

}  // namespace

PrefixCode::PrefixCode(std::vector<std::uint8_t> of_lengths)
    : lengths(std::move(of_lengths)), words(canonical_codes(lengths)) {}

SymbolCounts::SymbolCounts(std::span<const RepeatStep> steps)
    : literals(kLiterals), distances(kDistances) {
  literals[kEndOfBlock] = 1;
  for (const RepeatStep& step : steps) {
    if (step.length == 0) {
      ++literals[step.byte];
      continue;
    }
    const Ranged length = ranged_length(step.length);
    const Ranged distance = ranged_distance(step.distance);
    ++literals[length.symbol];
    ++distances[distance.symbol];
    rest_bits += static_cast<std::size_t>(length.rest_bits + distance.rest_bits);
  }
}

BlockCode BlockCode::fixed() {
  std::vector<std::uint8_t> lengths(288, 8);
  std::fill(lengths.begin() + 144, lengths.begin() + 256, std::uint8_t{9});
  std::fill(lengths.begin() + 256, lengths.begin() + 280, std::uint8_t{7});
  return {PrefixCode(lengths), PrefixCode(std::vector<std::uint8_t>(kDistances, 5))};
}

BlockCode BlockCode::made_for(const SymbolCounts& counts) {
  return {PrefixCode(code_lengths(counts.literals, kLongestWord)),
          PrefixCode(code_lengths(counts.distances, kLongestWord))};
}

void BlockCode::put_steps(BitWriter& to, std::span<const RepeatStep> steps) const {
  for (const RepeatStep& step : steps) {
    if (step.length == 0) {
      literals.put(to, step.byte);
      continue;
    }
    const Ranged length = ranged_length(step.length);
    literals.put(to, length.symbol);
    to.put(length.rest, length.rest_bits);
    const Ranged distance = ranged_distance(step.distance);
    distances.put(to, distance.symbol);
    to.put(distance.rest, distance.rest_bits);
  }
  literals.put(to, kEndOfBlock);
}

std::size_t BlockCode::bits(const SymbolCounts& counts) const {
  return cost(counts.literals, literals.lengths) + cost(counts.distances, distances.lengths) +
         counts.rest_bits;
}

ToldCode::ToldCode(const BlockCode& code)
    : literal_count_(used(code.literals.lengths, kEndOfBlock + 1)),
      distance_count_(used(code.distances.lengths, 1)) {
  const std::span<const std::uint8_t> distances = code.distances.lengths;
  std::vector<std::uint8_t> lengths = code.literals.lengths;
  lengths.resize(literal_count_);
  lengths.insert(lengths.end(), distances.begin(),
                 distances.begin() + static_cast<std::ptrdiff_t>(distance_count_));
  steps_ = steps_of(lengths);
  std::array<std::uint32_t, kStepOrder.size()> occurrences{};
  for (const Step& step : steps_) ++occurrences[step.symbol];
  step_code_ = PrefixCode(code_lengths(occurrences, kLongestStepWord));
  for (const std::uint8_t symbol : kStepOrder) step_lengths_.push_back(step_code_.lengths[symbol]);
  step_lengths_.resize(used(step_lengths_, 4));
}

void ToldCode::put(BitWriter& to) const {
  to.put(static_cast<std::uint32_t>(literal_count_ - (kEndOfBlock + 1)), 5);
  to.put(static_cast<std::uint32_t>(distance_count_ - 1), 5);
  to.put(static_cast<std::uint32_t>(step_lengths_.size() - 4), 4);
  for (const std::uint8_t length : step_lengths_) to.put(length, 3);
  for (const Step& step : steps_) {
    step_code_.put(to, step.symbol);
    to.put(step.rest, rest_bits_of_step(step.symbol));
  }
}

std::size_t ToldCode::bits() const {
  std::size_t sum = 5 + 5 + 4 + 3 * step_lengths_.size();
  for (const Step& step : steps_) {
    sum += step_code_.lengths[step.symbol];
    sum += static_cast<std::size_t>(rest_bits_of_step(step.symbol));
  }
  return sum;
}

// Symbols 0 to 15 are lengths; 16 repeats the one before 3 to 6 times, 17 and 18 stand for 3 to 10
// and 11 to 138 zeros.
std::vector<ToldCode::Step> ToldCode::steps_of(std::span<const std::uint8_t> lengths) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < lengths.size();) {
    const std::uint8_t length = lengths[i];
    const auto run_from = [&](std::size_t start, std::size_t most) {
      std::size_t n = 0;
      while (start + n < lengths.size() && n < most && lengths[start + n] == length) ++n;
      return n;
    };
    const std::size_t zeros = length == 0 ? run_from(i, 138) : 0;
    if (zeros >= 11) {
      steps.push_back({18, static_cast<std::uint8_t>(zeros - 11)});
      i += zeros;
    } else if (zeros >= 3) {
      steps.push_back({17, static_cast<std::uint8_t>(zeros - 3)});
      i += zeros;
    } else {
      steps.push_back({length});
      ++i;
      const std::size_t repeats = length == 0 ? 0 : run_from(i, 6);
      if (repeats < 3) continue;
      steps.push_back({16, static_cast<std::uint8_t>(repeats - 3)});
      i += repeats;
    }
  }
  return steps;
}

std::size_t used(std::span<const std::uint8_t> lengths, std::size_t at_least) {
  std::size_t n = lengths.size();
  while (n > at_least && lengths[n - 1] == 0) --n;
  return n;
}

}  // namespace tetsculpt
