#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace tetsculpt {

/// Numbers of some bits each as bytes, lowest bit first.
class BitWriter {
 public:
  /// Precondition: 0 <= value < 2^bits, bits <= 32.
  void put(std::uint32_t value, int bits) {
    pending_ |= std::uint64_t{value} << pending_bits_;
    for (pending_bits_ += bits; pending_bits_ >= 8; pending_bits_ -= 8) take_byte();
  }

  /// Zeros up to the end of the byte.
  void end_byte() {
    if (pending_bits_ > 0) take_byte();
    pending_bits_ = 0;
  }

  /// Whole bytes, behind the end of one.
  void append(std::string_view bytes) { out_.append(bytes); }

  /// All that was put in. Precondition: at the end of a byte.
  std::string take() && { return std::move(out_); }

 private:
  void take_byte() {
    out_.push_back(static_cast<char>(pending_ & 0xff));
    pending_ >>= 8;
  }

  std::string out_;
  std::uint64_t pending_ = 0;
  int pending_bits_ = 0;
};

}  // namespace tetsculpt
