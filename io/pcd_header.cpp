// The header of the PCD file format, version 0.7, as the Point Cloud Library documents it.
#include "io/pcd_header.h"

#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace tetsculpt {
namespace {

constexpr std::uint64_t kMostNumbers = 10'000;  // of a point

NumberType number_type(char kind, std::uint64_t size, const TextScanner& in) {
  constexpr std::pair<std::string_view, NumberType> kTypes[] = {
      {"I1", NumberType::kInt8},   {"U1", NumberType::kUint8},  {"I2", NumberType::kInt16},
      {"U2", NumberType::kUint16}, {"I4", NumberType::kInt32},  {"U4", NumberType::kUint32},
      {"I8", NumberType::kInt64},  {"U8", NumberType::kUint64}, {"F4", NumberType::kFloat32},
      {"F8", NumberType::kFloat64}};
  const std::string wanted = kind + std::to_string(size);
  for (const auto& [name, type] : kTypes) {
    if (name == wanted) return type;
  }
  in.fail("no type of numbers has TYPE " + std::string(1, kind) + " and SIZE " +
          std::to_string(size));
}

class HeaderBuilder {
 public:
  explicit HeaderBuilder(TextScanner& in) : in_(in) {}

  // False if the line was the last one.
  bool take_line() {
    const std::string_view keyword = in_.token();
    if (keyword == "FIELDS") {
      while (!in_.at_line_end()) names_.emplace_back(in_.token());
    } else if (keyword == "SIZE") {
      take_counts(sizes_);
    } else if (keyword == "COUNT") {
      take_counts(counts_);
    } else if (keyword == "TYPE") {
      while (!in_.at_line_end()) types_.emplace_back(in_.token());
    } else if (keyword == "WIDTH") {
      width_ = in_.count();
    } else if (keyword == "HEIGHT") {
      height_ = in_.count();
    } else if (keyword == "POINTS") {
      points_ = in_.count();
    } else if (keyword == "DATA") {
      return false;
    } else if (keyword != "VERSION" && keyword != "VIEWPOINT") {
      in_.fail("not a line of a PCD header");
    }
    return true;
  }

  PcdHeader finish() && {
    PcdHeader header;
    header.data = data();
    header.points = points();
    if (counts_.empty()) counts_.resize(names_.size(), 1);
    check_number_of(sizes_.size(), "SIZE");
    check_number_of(types_.size(), "TYPE");
    check_number_of(counts_.size(), "COUNT");
    std::uint64_t numbers = 0;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (types_[i].size() != 1) in_.fail("unknown TYPE of the field " + names_[i]);
      const NumberType type = number_type(types_[i].front(), sizes_[i], in_);
      if (counts_[i] == 0 || counts_[i] > kMostNumbers - numbers) {
        in_.fail("a COUNT is zero, or a point has more than " + std::to_string(kMostNumbers) +
                 " numbers");
      }
      numbers += counts_[i];
      header.fields.push_back({names_[i], type, static_cast<std::size_t>(counts_[i])});
    }
    return header;
  }

 private:
  void take_counts(std::vector<std::uint64_t>& counts) {
    while (!in_.at_line_end()) counts.push_back(in_.count());
  }

  PcdData data() {
    const std::string_view name = in_.token();
    if (name == "ascii") return PcdData::kAscii;
    if (name == "binary") return PcdData::kBinary;
    if (name == "binary_compressed") return PcdData::kCompressed;
    in_.fail("unknown DATA; ascii, binary and binary_compressed are read");
  }

  std::uint64_t points() const {
    if (!width_ || !height_) {
      if (!points_) in_.fail("the header has no POINTS");
      return *points_;
    }
    if (*height_ != 0 && *width_ > std::numeric_limits<std::uint64_t>::max() / *height_) {
      in_.fail("WIDTH times HEIGHT is out of range");
    }
    const std::uint64_t area = *width_ * *height_;
    if (points_ && *points_ != area) {
      in_.fail("POINTS is " + std::to_string(*points_) + ", WIDTH times HEIGHT is " +
               std::to_string(area));
    }
    return area;
  }

  void check_number_of(std::size_t values, std::string_view keyword) const {
    if (values == names_.size()) return;
    in_.fail("FIELDS names " + std::to_string(names_.size()) + " fields, " + std::string(keyword) +
             " has " + std::to_string(values) + " values");
  }

  TextScanner& in_;
  std::vector<std::string> names_;
  std::vector<std::string> types_;
  std::vector<std::uint64_t> sizes_;
  std::vector<std::uint64_t> counts_;
  std::optional<std::uint64_t> width_;
  std::optional<std::uint64_t> height_;
  std::optional<std::uint64_t> points_;
};

}  // namespace

PcdHeader parse_pcd_header(TextScanner& in) {
  HeaderBuilder builder(in);
  do {
    if (!in.next_content_line()) in.fail("the file ends within the PCD header");
  } while (builder.take_line());
  return std::move(builder).finish();
}

std::size_t record_size(const PcdHeader& header) {
  std::size_t size = 0;
  for (const PcdField& field : header.fields) size += byte_size(field.type) * field.count;
  return size;
}

}  // namespace tetsculpt
