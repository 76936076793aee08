// "LAS Specification 1.4 - R15" (ASPRS 2019), with the older versions' point formats 0 to 5.
#include "io/las_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/binary_columns.h"
#include "io/byte_order.h"
#include "io/io_error.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kOldHeaderSize = 227;
constexpr std::size_t kNewHeaderSize = 375;  // of version 1.4

// Bytes of a record, by point format.
constexpr std::array<std::size_t, 11> kRecordSizes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

// Some bits of a byte of the record.
struct BitField {
  std::string_view name;
  std::size_t offset;
  int shift;
  int bits;
};

struct Field {
  std::string_view name;
  std::size_t offset;
  NumberType type;
};

constexpr std::array<BitField, 6> kOldBitFields = {{{"return_number", 14, 0, 3},
                                                    {"number_of_returns", 14, 3, 3},
                                                    {"scan_direction", 14, 6, 1},
                                                    {"edge_of_flight_line", 14, 7, 1},
                                                    {"classification", 15, 0, 5},
                                                    {"classification_flags", 15, 5, 3}}};
constexpr std::array<BitField, 6> kNewBitFields = {{{"return_number", 14, 0, 4},
                                                    {"number_of_returns", 14, 4, 4},
                                                    {"classification_flags", 15, 0, 4},
                                                    {"scanner_channel", 15, 4, 2},
                                                    {"scan_direction", 15, 6, 1},
                                                    {"edge_of_flight_line", 15, 7, 1}}};

// Of the formats from 6 on.
bool is_new(unsigned format) { return format >= 6; }

std::vector<Field> fields_of(unsigned format) {
  std::vector<Field> fields = {{"intensity", 12, NumberType::kUint16}};
  const auto add_colours = [&fields](std::size_t at) {
    for (const char* name : {"red", "green", "blue"}) {
      fields.push_back({name, at, NumberType::kUint16});
      at += 2;
    }
  };
  if (is_new(format)) {
    fields.push_back({"classification", 16, NumberType::kUint8});
    fields.push_back({"user_data", 17, NumberType::kUint8});
    fields.push_back({"scan_angle", 18, NumberType::kInt16});
    fields.push_back({"point_source_id", 20, NumberType::kUint16});
    fields.push_back({"gps_time", 22, NumberType::kFloat64});
    if (format == 7 || format == 8 || format == 10) add_colours(30);
    if (format == 8 || format == 10) fields.push_back({"nir", 36, NumberType::kUint16});
    return fields;
  }
  fields.push_back({"scan_angle", 16, NumberType::kInt8});
  fields.push_back({"user_data", 17, NumberType::kUint8});
  fields.push_back({"point_source_id", 18, NumberType::kUint16});
  if (format == 1 || format >= 3) fields.push_back({"gps_time", 20, NumberType::kFloat64});
  if (format == 2) add_colours(20);
  if (format == 3 || format == 5) add_colours(28);
  return fields;
}

// What the header says, checked against the size of the file.
class LasHeader {
 public:
  LasHeader(std::string_view content, const std::filesystem::path& path)
      : content_(content), path_(path) {
    if (!content.starts_with("LASF")) throw IoError(path, "not a LAS file");
    if (content.size() < kOldHeaderSize) fail(content.size(), "the file ends within the header");
    check_version();
    points_at = at<std::uint32_t>(96);
    check_format();
    record_size = at<std::uint16_t>(105);
    if (record_size < kRecordSizes[format]) {
      fail(105, "records of " + std::to_string(record_size) + " bytes; point format " +
                    std::to_string(format) + " has " + std::to_string(kRecordSizes[format]));
    }
    count = announced_count();
    check_room();
  }

  template <typename Number>
  Number at(std::size_t offset) const {
    return load_number<Number>(content_.data() + offset, std::endian::little);
  }

  unsigned format = 0;
  std::size_t points_at = 0;
  std::size_t record_size = 0;
  std::uint64_t count = 0;

 private:
  void check_version() {
    const unsigned major = at<std::uint8_t>(24);
    const unsigned minor = at<std::uint8_t>(25);
    if (major != 1 || minor > 4) {
      fail(24, "LAS version " + std::to_string(major) + "." + std::to_string(minor) +
                   "; 1.0 to 1.4 are read");
    }
    has_long_count_ = minor == 4;
    const std::size_t least = has_long_count_ ? kNewHeaderSize : kOldHeaderSize;
    header_size_ = at<std::uint16_t>(94);
    if (header_size_ < least) {
      fail(94, "a header of " + std::to_string(header_size_) + " bytes; this version has " +
                   std::to_string(least));
    }
    if (header_size_ > content_.size()) fail(content_.size(), "the file ends within the header");
  }

  void check_format() {
    constexpr unsigned kCompressed = 0xC0;
    format = at<std::uint8_t>(104);
    if ((format & kCompressed) != 0) {
      throw IoError(path_,
                    "the points are compressed (LAZ): decompress them first, for example with "
                    "laszip");
    }
    if (format >= kRecordSizes.size()) {
      fail(104, "unknown point format " + std::to_string(format) + "; 0 to 10 are read");
    }
    if (points_at < header_size_) fail(96, "the points begin within the header");
  }

  // Each of the two counts may be left zero by those who need the other.
  std::uint64_t announced_count() const {
    const std::uint64_t short_count = at<std::uint32_t>(107);
    if (!has_long_count_) return short_count;
    const auto long_count = at<std::uint64_t>(247);
    if (short_count != 0 && long_count != 0 && short_count != long_count) {
      fail(247, "two counts of points that differ: " + std::to_string(short_count) + " and " +
                    std::to_string(long_count));
    }
    return std::max(short_count, long_count);
  }

  void check_room() const {
    const std::size_t left = content_.size() - std::min(points_at, content_.size());
    if (count <= left / record_size) return;
    fail(std::min(points_at, content_.size()),
         "points: " + std::to_string(count) + " of " + std::to_string(record_size) +
             " bytes announced, " + std::to_string(left) + " bytes left");
  }

  [[noreturn]] void fail(std::size_t byte, std::string_view reason) const {
    throw IoError(path_, ByteOffset{byte}, reason);
  }

  std::string_view content_;
  const std::filesystem::path& path_;
  std::size_t header_size_ = 0;
  bool has_long_count_ = false;
};

std::vector<Point3> scaled_points(const LasHeader& header, const char* records) {
  const std::array scale = {header.at<double>(131), header.at<double>(139), header.at<double>(147)};
  const std::array offset = {header.at<double>(155), header.at<double>(163),
                             header.at<double>(171)};
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(header.count));
  for (std::uint64_t i = 0; i < header.count; ++i, records += header.record_size) {
    const auto coordinate = [&](std::size_t axis) {
      const auto whole = load_number<std::int32_t>(records + 4 * axis, std::endian::little);
      return whole * scale[axis] + offset[axis];
    };
    points.push_back({coordinate(0), coordinate(1), coordinate(2)});
  }
  return points;
}

std::vector<std::uint8_t> bits_of(const LasHeader& header, const char* records,
                                  const BitField& field) {
  std::vector<std::uint8_t> values;
  values.reserve(static_cast<std::size_t>(header.count));
  const int mask = (1 << field.bits) - 1;
  for (std::uint64_t i = 0; i < header.count; ++i, records += header.record_size) {
    const auto byte = static_cast<std::uint8_t>(records[field.offset]);
    values.push_back(static_cast<std::uint8_t>(byte >> field.shift & mask));
  }
  return values;
}

}  // namespace

PointFile parse_las_points(std::string_view content, const std::filesystem::path& path) {
  const LasHeader header(content, path);
  PointFile file;
  if (header.count == 0) return file;
  const char* const records = content.data() + header.points_at;
  file.points = scaled_points(header, records);
  for (const Field& field : fields_of(header.format)) {
    const BinaryColumn column{field.type, records + field.offset, header.record_size};
    file.attributes.push_back(
        {std::string(field.name), values_of(column, file.points.size(), std::endian::little)});
  }
  for (const BitField& field : is_new(header.format) ? kNewBitFields : kOldBitFields) {
    file.attributes.push_back({std::string(field.name), bits_of(header, records, field)});
  }
  return file;
}

}  // namespace tetsculpt
