#include "io/text_rows.h"

#include <cassert>
#include <charconv>
#include <cstddef>

namespace tetsculpt {
namespace {

// A row under construction. Prefix and suffix are short; three numbers take at most 3 * 24.
class Row {
 public:
  void add(std::string_view text) {
    assert(text.size() <= row_.size() - size_);
    text.copy(row_.data() + size_, text.size());
    size_ += text.size();
  }

  template <typename Number>
  void add_number(Number value) {
    char* const begin = row_.data() + size_;
    const auto result = std::to_chars(begin, row_.data() + row_.size(), value);
    size_ += static_cast<std::size_t>(result.ptr - begin);
  }

  std::string_view view() const { return {row_.data(), size_}; }

 private:
  std::array<char, 128> row_;
  std::size_t size_ = 0;
};

}  // namespace

void write_point_row(AtomicFile& out, std::string_view prefix, const Point3& point) {
  Row row;
  row.add(prefix);
  row.add_number(point.x);
  row.add(" ");
  row.add_number(point.y);
  row.add(" ");
  row.add_number(point.z);
  row.add("\n");
  out.write(row.view());
}

void write_index_row(AtomicFile& out, std::string_view prefix,
                     const std::array<std::uint32_t, 3>& triangle, std::uint64_t first,
                     std::string_view suffix) {
  Row row;
  row.add(prefix);
  row.add_number(first + triangle[0]);
  row.add(" ");
  row.add_number(first + triangle[1]);
  row.add(" ");
  row.add_number(first + triangle[2]);
  row.add(suffix);
  out.write(row.view());
}

}  // namespace tetsculpt
