// LZ77 with hash chains and one step of lazy evaluation: a repeat waits for a longer one that
// begins at the next byte, as RFC 1951 proposes in section 4.
#include "io/repeats.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace tetsculpt {
namespace {

constexpr std::size_t kWindow = 32768;
constexpr std::size_t kShortest = 3;
constexpr std::size_t kLongest = 258;
constexpr int kChain = 48;               // places tried
constexpr std::size_t kLongEnough = 96;  // then no better one is looked for
constexpr int kHashBits = 15;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

struct Repeat {
  std::size_t length = 0;
  std::size_t distance = 0;
};

/// The places seen, by what stands there.
class Places {
 public:
  explicit Places(std::string_view bytes)
      : bytes_(bytes), newest_(std::size_t{1} << kHashBits, kNone), older_(kWindow, kNone) {}

  void add(std::size_t at) {
    if (at + kShortest > bytes_.size()) return;
    std::size_t& newest = newest_[hash(at)];
    older_[at % kWindow] = newest;
    newest = at;
  }

  /// The longest repeat at `at`; of equal ones the nearest.
  Repeat longest(std::size_t at) const {
    Repeat best;
    if (at + kShortest > bytes_.size()) return best;
    std::size_t from = newest_[hash(at)];
    for (int i = 0; i < kChain && from != kNone && at - from <= kWindow; ++i) {
      const std::size_t length = common(from, at);
      if (length >= kShortest && length > best.length) best = {length, at - from};
      if (best.length >= kLongEnough) break;
      // A slot that a later place has taken over leads forwards, or back beyond the window.
      const std::size_t next = older_[from % kWindow];
      if (next == kNone || next >= from) break;
      from = next;
    }
    return best;
  }

 private:
  std::size_t hash(std::size_t at) const {
    const auto byte = [&](std::size_t i) { return std::uint32_t{std::uint8_t(bytes_[at + i])}; };
    const std::uint32_t three = byte(0) | byte(1) << 8 | byte(2) << 16;
    return (three * 2654435761U) >> (32 - kHashBits);
  }

  std::size_t common(std::size_t a, std::size_t b) const {
    const std::size_t limit = std::min(kLongest, bytes_.size() - b);
    std::size_t length = 0;
    while (length < limit && bytes_[a + length] == bytes_[b + length]) ++length;
    return length;
  }

  std::string_view bytes_;
  std::vector<std::size_t> newest_;
  std::vector<std::size_t> older_;  // the place before, of the same hash; by place modulo window
};

}  // namespace

std::vector<RepeatStep> find_repeats(std::string_view bytes) {
  std::vector<RepeatStep> steps;
  Places places(bytes);
  Repeat here = places.longest(0);
  for (std::size_t at = 0; at < bytes.size();) {
    places.add(at);
    const Repeat next = here.length < kLongEnough ? places.longest(at + 1) : Repeat{};
    if (here.length == 0 || next.length > here.length) {
      steps.push_back({.byte = static_cast<std::uint8_t>(bytes[at])});
      ++at;
      here = next;
      continue;
    }
    steps.push_back({.length = static_cast<std::uint16_t>(here.length),
                     .distance = static_cast<std::uint16_t>(here.distance)});
    for (std::size_t i = 1; i < here.length; ++i) places.add(at + i);
    at += here.length;
    here = places.longest(at);
  }
  return steps;
}

}  // namespace tetsculpt
