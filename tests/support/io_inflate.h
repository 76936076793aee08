#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The reader of zlib streams that the tests of the writer rest on: slow, and written from the
/// standard alone. Throws std::runtime_error at the first thing that is not as it must be.
namespace tetsculpt::testing {

/// The blocks of a stream by their form, and what they hold.
struct Inflated {
  std::string bytes;
  std::array<int, 3> blocks{};  ///< as they are, fixed code, own code
};

class Inflater {
 public:
  explicit Inflater(std::string_view stream) : stream_(stream) {}

  Inflated run() {
    const std::size_t method = bits(8);
    require(method == 0x78 && (method * 256 + bits(8)) % 31 == 0, "header");
    while (!block()) {
    }
    at_ = (at_ + 7) / 8 * 8;
    std::uint32_t sum = 0;
    for (int i = 0; i < 4; ++i) sum = sum << 8 | static_cast<std::uint32_t>(bits(8));
    require(at_ == 8 * stream_.size(), "end");
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char byte : out_.bytes) {
      a = (a + static_cast<std::uint8_t>(byte)) % 65521;
      b = (b + a) % 65521;
    }
    require(sum == (b << 16 | a), "sum");
    return std::move(out_);
  }

 private:
  using Words = std::map<std::pair<std::size_t, std::size_t>, std::size_t>;  // length and word

  static void require(bool good, const char* what) {
    if (!good) throw std::runtime_error(std::string("zlib stream: ") + what);
  }

  std::size_t bits(std::size_t count) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < count; ++i, ++at_) {
      require(at_ < 8 * stream_.size(), "too short");
      const auto byte = static_cast<std::uint8_t>(stream_[at_ / 8]);
      value |= static_cast<std::size_t>(byte >> at_ % 8 & 1) << i;
    }
    return value;
  }

  // RFC 1951, sec. 3.2.2. A code must be complete, or of one word at most.
  static Words words_of(const std::vector<std::size_t>& lengths) {
    Words words;
    std::size_t next = 0;
    std::size_t left = std::size_t{1} << 15;  // of all words, in units of the shortest share
    for (std::size_t length = 1; length <= 15; ++length, next <<= 1) {
      for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
        if (lengths[symbol] != length) continue;
        require(left >= std::size_t{1} << (15 - length), "too many words");
        left -= std::size_t{1} << (15 - length);
        words[{length, next++}] = symbol;
      }
    }
    require(left == 0 || words.size() <= 1, "words left over");
    return words;
  }

  std::size_t symbol(const Words& words) {
    std::size_t word = 0;
    for (std::size_t length = 1; length <= 15; ++length) {
      word = word << 1 | bits(1);
      if (const auto it = words.find({length, word}); it != words.end()) return it->second;
    }
    throw std::runtime_error("zlib stream: no such word");
  }

  bool block() {
    const bool last = bits(1) == 1;
    const std::size_t form = bits(2);
    require(form < 3, "form");
    ++out_.blocks[form];
    if (form == 0) {
      stored();
    } else if (form == 1) {
      std::vector<std::size_t> lengths(288, 8);
      for (std::size_t i = 144; i < 256; ++i) lengths[i] = 9;
      for (std::size_t i = 256; i < 280; ++i) lengths[i] = 7;
      coded(words_of(lengths), words_of(std::vector<std::size_t>(32, 5)));
    } else {
      const std::size_t literals = bits(5) + 257;
      const std::size_t distances = bits(5) + 1;
      require(literals <= 286 && distances <= 30, "sizes of codes");
      const std::vector<std::size_t> all = told_lengths(literals + distances);
      const auto middle = all.begin() + static_cast<std::ptrdiff_t>(literals);
      coded(words_of({all.begin(), middle}), words_of({middle, all.end()}));
    }
    return last;
  }

  void stored() {
    at_ = (at_ + 7) / 8 * 8;
    const std::size_t size = bits(16);
    require((size ^ 0xffff) == bits(16), "size of stored block");
    for (std::size_t i = 0; i < size; ++i) out_.bytes.push_back(static_cast<char>(bits(8)));
  }

  std::vector<std::size_t> told_lengths(std::size_t count) {
    constexpr std::size_t kOrder[] = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                      11, 4,  12, 3, 13, 2, 14, 1, 15};
    const std::size_t told = bits(4) + 4;
    std::vector<std::size_t> step_lengths(19);
    for (std::size_t i = 0; i < told; ++i) step_lengths[kOrder[i]] = bits(3);
    const Words steps = words_of(step_lengths);
    std::vector<std::size_t> lengths;
    while (lengths.size() < count) {
      const std::size_t step = symbol(steps);
      if (step < 16) lengths.push_back(step);
      if (step == 16) require(!lengths.empty(), "nothing to repeat");
      if (step == 16) lengths.insert(lengths.end(), bits(2) + 3, std::size_t{lengths.back()});
      if (step == 17) lengths.insert(lengths.end(), bits(3) + 3, 0);
      if (step == 18) lengths.insert(lengths.end(), bits(7) + 11, 0);
    }
    require(lengths.size() == count, "too many lengths");
    return lengths;
  }

  void coded(const Words& literals, const Words& distances) {
    constexpr std::size_t kLengths[] = {3,  4,  5,  6,   7,   8,   9,   10,  11, 13,
                                        15, 17, 19, 23,  27,  31,  35,  43,  51, 59,
                                        67, 83, 99, 115, 131, 163, 195, 227, 258};
    constexpr std::size_t kDistances[] = {
        1,   2,   3,   4,   5,   7,    9,    13,   17,   25,   33,   49,   65,    97,    129,
        193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    for (std::size_t s = symbol(literals); s != 256; s = symbol(literals)) {
      if (s < 256) {
        out_.bytes.push_back(static_cast<char>(s));
        continue;
      }
      require(s < 286, "length");
      const std::size_t length_bits = s < 265 || s == 285 ? 0 : (s - 261) / 4;
      const std::size_t length = kLengths[s - 257] + bits(length_bits);
      const std::size_t d = symbol(distances);
      require(d < 30, "distance");
      const std::size_t distance = kDistances[d] + bits(d < 4 ? 0 : d / 2 - 1);
      require(distance <= out_.bytes.size() && distance <= 32768, "too far back");
      for (std::size_t i = 0; i < length; ++i) {
        out_.bytes.push_back(out_.bytes[out_.bytes.size() - distance]);
      }
    }
  }

  std::string_view stream_;
  std::size_t at_ = 0;  // in bits
  Inflated out_;
};

inline Inflated inflated(std::string_view zlib_stream) { return Inflater(zlib_stream).run(); }

}  // namespace tetsculpt::testing
