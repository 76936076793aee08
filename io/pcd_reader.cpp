#include "io/pcd_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/attribute_values.h"
#include "io/binary_columns.h"
#include "io/byte_order.h"
#include "io/column_names.h"
#include "io/io_error.h"
#include "io/lzf.h"
#include "io/pcd_header.h"
#include "io/text_scanner.h"

namespace tetsculpt {
namespace {

enum class Use { kX, kY, kZ, kAttribute, kColour, kColourAndAlpha, kNothing };

// One number of a point.
struct Column {
  Use use = Use::kNothing;
  std::string name;
  NumberType type = NumberType::kFloat32;

  bool is_coordinate() const { return use <= Use::kZ; }
  bool is_packed() const { return use == Use::kColour || use == Use::kColourAndAlpha; }
};

Use use_of(const PcdField& field, std::string_view name) {
  if (name.starts_with('_')) return Use::kNothing;
  if (field.count > 1) return Use::kAttribute;
  if (name == "x") return Use::kX;
  if (name == "y") return Use::kY;
  if (name == "z") return Use::kZ;
  const bool four_bytes = byte_size(field.type) == 4;
  if (four_bytes && name == "rgb") return Use::kColour;
  if (four_bytes && name == "rgba") return Use::kColourAndAlpha;
  return Use::kAttribute;
}

std::vector<Column> columns_of(const PcdHeader& header, const TextScanner& in) {
  std::vector<std::string> names;
  for (const PcdField& field : header.fields) names.push_back(field.name);
  names = canonical_names(std::move(names));
  if (!name_coordinates(names)) in.fail("FIELDS does not name x, y and z once each");
  std::vector<Column> columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const PcdField& field = header.fields[i];
    const Use use = use_of(field, names[i]);
    for (std::size_t part = 0; part < field.count; ++part) {
      const bool single = field.count == 1;
      columns.push_back({use, single ? names[i] : part_name(names[i], part), field.type});
    }
  }
  for (const char* name : {"x", "y", "z"}) {
    if (std::ranges::count(columns, name, &Column::name) != 1) {
      in.fail("the field " + std::string(name) + " has several numbers");
    }
  }
  return columns;
}

Precision precision_of(const std::vector<Column>& columns) {
  const bool single = std::ranges::all_of(columns, [](const Column& column) {
    return !column.is_coordinate() || column.type == NumberType::kFloat32;
  });
  return single ? Precision::kSingle : Precision::kDouble;
}

void add_colours(PointFile& file, std::span<const std::uint32_t> packed, Use use) {
  const auto add = [&](const char* name, int shift) {
    std::vector<std::uint8_t> values;
    values.reserve(packed.size());
    for (const std::uint32_t bits : packed) {
      values.push_back(static_cast<std::uint8_t>(bits >> shift & 0xff));
    }
    file.attributes.push_back({name, std::move(values)});
  };
  add("red", 16);
  add("green", 8);
  add("blue", 0);
  if (use == Use::kColourAndAlpha) add("alpha", 24);
}

PointFile from_binary(const std::vector<Column>& columns, const std::vector<BinaryColumn>& places,
                      std::size_t count) {
  constexpr std::endian kOrder = std::endian::little;
  PointFile file;
  std::array<BinaryColumn, 3> xyz;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Use use = columns[i].use;
    if (columns[i].is_coordinate()) {
      xyz[static_cast<std::size_t>(use)] = places[i];
    } else if (columns[i].is_packed()) {
      BinaryColumn bits = places[i];
      bits.type = NumberType::kUint32;
      const AttributeValues packed = values_of(bits, count, kOrder);
      add_colours(file, std::get<std::vector<std::uint32_t>>(packed), use);
    } else if (use == Use::kAttribute) {
      file.attributes.push_back({columns[i].name, values_of(places[i], count, kOrder)});
    }
  }
  file.points = points_of(xyz, count, kOrder);
  return file;
}

// Point after point.
std::vector<BinaryColumn> places_in_records(const PcdHeader& header, const char* data) {
  const std::size_t stride = record_size(header);
  std::vector<BinaryColumn> places;
  for (const PcdField& field : header.fields) {
    for (std::size_t part = 0; part < field.count; ++part) {
      places.push_back({field.type, data, stride});
      data += byte_size(field.type);
    }
  }
  return places;
}

// Field after field.
std::vector<BinaryColumn> places_in_fields(const PcdHeader& header, const char* data) {
  std::vector<BinaryColumn> places;
  for (const PcdField& field : header.fields) {
    const std::size_t size = byte_size(field.type);
    for (std::size_t part = 0; part < field.count; ++part) {
      places.push_back({field.type, data + part * size, field.count * size});
    }
    data += static_cast<std::size_t>(header.points) * field.count * size;
  }
  return places;
}

// What binary data is read from, for messages.
struct Data {
  std::string_view content;
  std::size_t begin;
  const std::filesystem::path& path;

  [[noreturn]] void fail(std::string_view reason) const {
    throw IoError(path, ByteOffset{begin}, reason);
  }
};

PointFile parse_binary(const PcdHeader& header, const std::vector<Column>& columns,
                       const Data& data) {
  const std::size_t left = data.content.size() - data.begin;
  if (header.points > left / record_size(header)) {
    data.fail("points: " + std::to_string(header.points) + " of " +
              std::to_string(record_size(header)) + " bytes announced, " + std::to_string(left) +
              " bytes left");
  }
  return from_binary(columns, places_in_records(header, data.content.data() + data.begin),
                     static_cast<std::size_t>(header.points));
}

PointFile parse_compressed(const PcdHeader& header, const std::vector<Column>& columns,
                           const Data& data) {
  constexpr std::size_t kSizes = 8;  // bytes of the two sizes before the data
  std::string_view bytes = data.content.substr(data.begin);
  if (bytes.size() < kSizes) data.fail("the file ends before the sizes of its compressed data");
  const auto size = [&](std::size_t at) -> std::size_t {
    return load_number<std::uint32_t>(bytes.data() + at, std::endian::little);
  };
  const std::size_t compressed = size(0);
  const std::size_t whole = size(4);
  bytes.remove_prefix(kSizes);
  if (header.points != whole / record_size(header) || whole % record_size(header) != 0) {
    data.fail("points: " + std::to_string(header.points) + " of " +
              std::to_string(record_size(header)) + " bytes announced, compressed data of " +
              std::to_string(whole) + " bytes");
  }
  if (compressed > bytes.size()) {
    data.fail("compressed data: " + std::to_string(compressed) + " bytes announced, " +
              std::to_string(bytes.size()) + " bytes left");
  }
  const std::optional<std::string> fields = lzf_decompressed(bytes.substr(0, compressed), whole);
  if (!fields) data.fail("the compressed data is broken");
  return from_binary(columns, places_in_fields(header, fields->data()),
                     static_cast<std::size_t>(header.points));
}

// As text a packed colour is the number that its bits are in the type of the field.
std::uint32_t packed_colour(TextScanner& in, NumberType type) {
  if (type == NumberType::kFloat32) {
    const auto value = in.number<float>();
    return std::isnan(value) ? 0 : std::bit_cast<std::uint32_t>(value);
  }
  AttributeValues value = empty_values(type, 1);
  append_number(value, in);
  if (type == NumberType::kUint32) return std::get<std::vector<std::uint32_t>>(value).front();
  return static_cast<std::uint32_t>(std::get<std::vector<std::int32_t>>(value).front());
}

class AsciiRows {
 public:
  AsciiRows(const std::vector<Column>& columns, std::size_t room) : columns_(columns) {
    file_.points.reserve(room);
    for (const Column& column : columns) {
      const NumberType type = column.is_packed() ? NumberType::kUint32 : column.type;
      const bool kept = column.use == Use::kAttribute || column.is_packed();
      values_.push_back(empty_values(type, kept ? room : 0));
    }
  }

  std::size_t size() const { return file_.points.size(); }

  void take(TextScanner& in) {
    std::array<double, 3> xyz{};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Column& column = columns_[i];
      if (column.is_coordinate()) {
        const bool single = column.type == NumberType::kFloat32;
        xyz[static_cast<std::size_t>(column.use)] =
            single ? double{in.number<float>()} : in.number<double>();
      } else if (column.is_packed()) {
        std::get<std::vector<std::uint32_t>>(values_[i]).push_back(packed_colour(in, column.type));
      } else if (column.use == Use::kAttribute) {
        append_number(values_[i], in);
      } else if (in.token().empty()) {
        in.fail("the line has fewer values than the header says");
      }
    }
    if (!in.at_line_end()) in.fail("the line has more values than the header says");
    file_.points.push_back({xyz[0], xyz[1], xyz[2]});
  }

  PointFile finish() && {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (columns_[i].is_packed()) {
        add_colours(file_, std::get<std::vector<std::uint32_t>>(values_[i]), columns_[i].use);
      } else if (columns_[i].use == Use::kAttribute) {
        file_.attributes.push_back({columns_[i].name, std::move(values_[i])});
      }
    }
    return std::move(file_);
  }

 private:
  const std::vector<Column>& columns_;
  std::vector<AttributeValues> values_;
  PointFile file_;
};

PointFile parse_ascii(const PcdHeader& header, const std::vector<Column>& columns,
                      TextScanner& in) {
  const std::size_t shortest_line = 2 * columns.size();
  AsciiRows rows(columns, static_cast<std::size_t>(std::min<std::uint64_t>(
                              header.points, in.bytes_left() / shortest_line + 1)));
  while (rows.size() < header.points) {
    if (!in.next_content_line()) {
      in.fail("the file ends after " + std::to_string(rows.size()) + " of " +
              std::to_string(header.points) + " points");
    }
    rows.take(in);
  }
  return std::move(rows).finish();
}

}  // namespace

PointFile parse_pcd_points(std::string_view content, const std::filesystem::path& path) {
  constexpr TextDialect kDialect;
  TextScanner in(content, path, kDialect);
  const PcdHeader header = parse_pcd_header(in);
  const std::vector<Column> columns = columns_of(header, in);
  const Data data{content, in.next_offset(), path};
  PointFile file = header.data == PcdData::kAscii    ? parse_ascii(header, columns, in)
                   : header.data == PcdData::kBinary ? parse_binary(header, columns, data)
                                                     : parse_compressed(header, columns, data);
  file.precision = precision_of(columns);
  return file;
}

}  // namespace tetsculpt
