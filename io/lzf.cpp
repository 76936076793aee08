// The format of Marc Lehmann's LibLZF: a control byte below 32 is followed by one byte more than it
// says; the others hold 3 bits of a length and 5 of a distance, whose other bits follow.
#include "io/lzf.h"

#include <cstdint>
#include <cstring>

namespace tetsculpt {
namespace {

constexpr std::size_t kLongestCopy = 7 + 255 + 2;
constexpr std::size_t kShortestStep = 3;  // bytes of such a copy

class Lzf {
 public:
  Lzf(std::string_view in, std::size_t size) : in_(in), out_(size, '\0') {}

  std::optional<std::string> run() && {
    while (at_ < in_.size()) {
      const std::size_t control = next();
      if (!(control < 32 ? literals(control + 1) : copy(control))) return std::nullopt;
    }
    if (done_ != out_.size()) return std::nullopt;
    return std::move(out_);
  }

 private:
  std::size_t next() { return static_cast<std::uint8_t>(in_[at_++]); }

  bool literals(std::size_t length) {
    if (length > in_.size() - at_ || length > out_.size() - done_) return false;
    std::memcpy(out_.data() + done_, in_.data() + at_, length);
    at_ += length;
    done_ += length;
    return true;
  }

  bool copy(std::size_t control) {
    std::size_t length = control >> 5;
    if (in_.size() - at_ < (length == 7 ? 2 : 1)) return false;
    if (length == 7) length += next();
    length += 2;
    const std::size_t distance = ((control & 31) << 8 | next()) + 1;
    if (distance > done_ || length > out_.size() - done_) return false;
    for (; length > 0; --length, ++done_) out_[done_] = out_[done_ - distance];  // may overlap
    return true;
  }

  std::string_view in_;
  std::string out_;
  std::size_t at_ = 0;
  std::size_t done_ = 0;
};

}  // namespace

std::optional<std::string> lzf_decompressed(std::string_view bytes, std::size_t size) {
  if (size / kLongestCopy > bytes.size() / kShortestStep) return std::nullopt;
  return Lzf(bytes, size).run();
}

}  // namespace tetsculpt
