#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/attribute.h"
#include "io/byte_order.h"
#include "kernel/point.h"

/// Reading binary legacy VTK files as their description says, apart from the writer.
namespace tetsculpt::testing {

class VtkFile {
 public:
  explicit VtkFile(const std::string& bytes) : bytes_(bytes) {
    if (line() != "# vtk DataFile Version 3.0") throw std::runtime_error("head");
    line();
    if (line() != "BINARY") throw std::runtime_error("BINARY");
    data_set = line();
    while (at_ < bytes_.size()) read_section();
  }

  std::string data_set;
  std::string point_type;
  std::vector<Point3> points;
  std::vector<std::vector<std::int32_t>> cells;
  std::vector<std::int32_t> cell_types;
  std::string attributes_of;  ///< POINT_DATA or CELL_DATA with its number
  std::vector<Attribute> attributes;

 private:
  std::string line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) throw std::runtime_error("no line");
    std::string text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return text;
  }

  static std::vector<std::string> words(const std::string& text) {
    std::vector<std::string> result(1);
    for (const char c : text) {
      if (c == ' ') {
        result.emplace_back();
      } else {
        result.back() += c;
      }
    }
    return result;
  }

  template <typename Number>
  Number number() {
    if (at_ + sizeof(Number) > bytes_.size()) throw std::runtime_error("cut off");
    const auto value = load_number<Number>(bytes_.data() + at_, std::endian::big);
    at_ += sizeof(Number);
    return value;
  }

  template <typename Number>
  std::vector<Number> numbers(std::size_t count) {
    std::vector<Number> result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(number<Number>());
    if (!line().empty()) throw std::runtime_error("no line end behind numbers");
    return result;
  }

  AttributeValues values(const std::string& type, std::size_t count) {
    if (type == "char") return numbers<std::int8_t>(count);
    if (type == "unsigned_char") return numbers<std::uint8_t>(count);
    if (type == "short") return numbers<std::int16_t>(count);
    if (type == "unsigned_short") return numbers<std::uint16_t>(count);
    if (type == "int") return numbers<std::int32_t>(count);
    if (type == "unsigned_int") return numbers<std::uint32_t>(count);
    if (type == "float") return numbers<float>(count);
    if (type == "double") return numbers<double>(count);
    throw std::runtime_error("type " + type);
  }

  void read_section() {
    const std::string head = line();
    const std::vector<std::string> word = words(head);
    const auto count = [&](std::size_t i) { return std::size_t{std::stoul(word.at(i))}; };
    if (word[0] == "POINTS") {
      point_type = word.at(2);
      std::vector<double> flat;
      std::visit([&](const auto& v) { flat.assign(v.begin(), v.end()); },
                 values(point_type, 3 * count(1)));
      for (std::size_t i = 0; i < flat.size(); i += 3) {
        points.push_back({flat[i], flat[i + 1], flat[i + 2]});
      }
    } else if (word[0] == "POLYGONS" || word[0] == "CELLS") {
      const auto flat = numbers<std::int32_t>(count(2));
      for (std::size_t i = 0; i < flat.size(); i += static_cast<std::size_t>(flat[i]) + 1) {
        cells.emplace_back(flat.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                           flat.begin() + static_cast<std::ptrdiff_t>(i) + 1 + flat[i]);
      }
      if (cells.size() != count(1)) throw std::runtime_error("number of cells");
    } else if (word[0] == "CELL_TYPES") {
      cell_types = numbers<std::int32_t>(count(1));
    } else if (word[0] == "POINT_DATA" || word[0] == "CELL_DATA") {
      attributes_of = head;
      rows_ = count(1);
    } else if (word[0] == "SCALARS" && word.at(3) == "1") {
      if (line() != "LOOKUP_TABLE default") throw std::runtime_error("LOOKUP_TABLE");
      attributes.push_back({word.at(1), values(word.at(2), rows_)});
    } else {
      throw std::runtime_error("section " + head);
    }
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
  std::size_t rows_ = 0;
};

}  // namespace tetsculpt::testing
