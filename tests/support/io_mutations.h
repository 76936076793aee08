#pragma once

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include "io/io_error.h"

/// Readers tried on files that are nearly right.
namespace tetsculpt::testing {

inline constexpr int kMutations = 20'000;  // of each file
inline constexpr std::uint64_t kSeed = 77;

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  std::string mutated(std::string file) {
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(file);
    return file;
  }

 private:
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_() % limit); }

  void change(std::string& file) {
    constexpr std::string_view kTelling = "\n\r\t ,;#/-+.eE0159\xFF\x7F\x80naif\0";
    const std::size_t at = below(file.size() + 1);
    const std::size_t length = below(8);
    switch (below(6)) {
      case 0:
        if (at < file.size()) file[at] = static_cast<char>(file[at] ^ (1 << below(8)));
        break;
      case 1:
        file.resize(at);
        break;
      case 2:
        file.insert(at, 1 + length, static_cast<char>(below(256)));
        break;
      case 3:
        file.insert(at, 1, kTelling[below(kTelling.size())]);
        break;
      case 4:
        file.erase(at, length);
        break;
      default:
        file.insert(at, file.substr(below(file.size() + 1), 4 * length));
    }
  }

  std::mt19937_64 random_;
};

// Runs `parse` over mutations of `file`; true if some were read and some refused.
template <typename Parse>
bool survives(const std::string& file, Parse parse) {
  Mutator mutator(kSeed);
  int read = 0;
  int refused = 0;
  parse(file, "valid");
  for (int i = 0; i < kMutations; ++i) {
    const std::string content = mutator.mutated(file);
    try {
      parse(content, "mutated");
      ++read;
    } catch (const IoError&) {
      ++refused;
    } catch (const std::exception& other) {
      FAIL("seed " << kSeed << ", mutation " << i << ": " << other.what());
    }
  }
  return read > 0 && refused > 0;
}

}  // namespace tetsculpt::testing
