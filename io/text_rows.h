#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "io/atomic_file.h"
#include "io/attribute.h"
#include "kernel/point.h"

namespace tetsculpt {

/// Text on its way to a file. Each number is the shortest text that reads back as the same number
/// of its type; -0.0 keeps its sign, and the locale has no influence.
class TextRows {
 public:
  explicit TextRows(AtomicFile& out) : out_(out) {}
  TextRows(const TextRows&) = delete;
  TextRows& operator=(const TextRows&) = delete;

  void add(std::string_view text);
  template <typename Number>
  void add_number(Number value) {
    make_room(kLongestNumber);
    char* const begin = block_.data() + size_;
    size_ +=
        static_cast<std::size_t>(std::to_chars(begin, begin + kLongestNumber, value).ptr - begin);
  }
  /// x, y and z with blanks between them.
  void add_point(const Point3& point);
  /// The three indices counted from `first`, with blanks between them.
  void add_indices(const std::array<std::uint32_t, 3>& triangle, std::uint64_t first);
  /// A row for each triangle: its indices, counted from `first`, between two texts.
  void add_triangles(std::span<const std::array<std::uint32_t, 3>> triangles,
                     std::string_view before, std::uint64_t first, std::string_view after);
  /// Value `i` as it is.
  void add_value(const AttributeValues& values, std::size_t i);
  /// Value `i` as a share of the largest of its type, as a float, if it is an integer; or as it is.
  void add_share(const AttributeValues& values, std::size_t i);
  /// The same, and nobody takes it for an integer: it has a point or an exponent.
  void add_fraction(const AttributeValues& values, std::size_t i);
  /// The last call: what has not gone to the file goes there.
  void finish();

 private:
  static constexpr std::size_t kLongestNumber = 32;
  void make_room(std::size_t bytes) {
    if (bytes > block_.size() - size_) finish();
  }

  AtomicFile& out_;
  std::array<char, 16384> block_;
  std::size_t size_ = 0;
};

}  // namespace tetsculpt
