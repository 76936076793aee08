#include "tools/point_facts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <variant>

#include "io/extension.h"
#include "io/point_format.h"
#include "kernel/distinct_points.h"
#include "kernel/first_simplex.h"
#include "kernel/nearest_distances.h"
#include "tools/json.h"
#include "tools/messages.h"

namespace tetsculpt::cli {
namespace {

constexpr std::array<std::string_view, 5> kSpans = {"nothing", "a point", "a line", "a plane",
                                                    "a solid"};
constexpr std::array<std::string_view, 8> kTypes = {"int8",  "uint8",  "int16", "uint16",
                                                    "int32", "uint32", "float", "double"};
static_assert(std::variant_size_v<AttributeValues> == kTypes.size());
constexpr std::array<std::string_view, 5> kQuartiles = {"least", "quarter", "median",
                                                        "three_quarters", "largest"};

/// The extension where it names the format of the file, or else a name of it.
std::string format_of(const PointFile& file, const std::filesystem::path& name) {
  if (point_format_of(name) == file.format) return lowercase_extension(name).substr(1);
  return std::string(point_format_name(file.format));
}

/// Each is one of the values; the lower one if it falls between two.
Quartiles quartiles(std::vector<double> values) {
  std::ranges::sort(values);
  Quartiles result{};
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = values[(values.size() - 1) * i / 4];
  return result;
}

std::string_view span_name(const PointFacts& facts) {
  return kSpans[static_cast<std::size_t>(facts.span)];
}

std::string_view name(Precision precision) {
  return precision == Precision::kSingle ? "32-bit floats" : "64-bit floats";
}

/// The fewest digits that tell it from other numbers of this precision.
std::string shortest(double value, Precision precision) {
  char digits[64];
  char* const end = digits + sizeof digits;
  return {digits, precision == Precision::kSingle
                      ? std::to_chars(digits, end, static_cast<float>(value)).ptr
                      : std::to_chars(digits, end, value).ptr};
}

std::string coordinates(const Point3& p, Precision precision) {
  return shortest(p.x, precision) + ' ' + shortest(p.y, precision) + ' ' + shortest(p.z, precision);
}

std::string corner_json(const PointFacts& facts, const Point3& p) {
  if (facts.box.empty) return "null";
  JsonArray numbers;
  for (const double x : {p.x, p.y, p.z}) numbers.add_raw(json_number(x));
  return numbers.text();
}

}  // namespace

PointFacts point_facts(const PointFile& file, const std::filesystem::path& name,
                       std::size_t invalid, Spacing spacing) {
  const DistinctPoints distinct = distinct_points(file.points);
  PointFacts facts;
  facts.file = name.string();
  facts.format = format_of(file, name);
  facts.precision = file.precision;
  facts.points = file.points.size() + invalid;
  facts.invalid = invalid;
  facts.distinct = distinct.points.size();
  facts.span = static_cast<Span>(first_simplex(distinct.points).size);
  facts.box = box_of(file.points);
  for (const Attribute& attribute : file.attributes) {
    facts.attributes.emplace_back(attribute.name, kTypes[attribute.values.index()]);
  }
  if (spacing == Spacing::kMeasured && facts.distinct >= 2) {
    facts.spacing = quartiles(nearest_distances(distinct.points));
    for (double& x : *facts.spacing) x = std::ldexp(x, -distinct.scale_exponent);
  }
  return facts;
}

std::string facts_text(const PointFacts& facts) {
  std::string text = facts.file + ": " + counted(facts.points, "point");
  text += "\nformat        " + facts.format + ", coordinates as ";
  text += name(facts.precision);
  text += "\ninvalid       " + std::to_string(facts.invalid);
  text += "\nduplicates    " + std::to_string(facts.duplicates());
  text += "\nspan          ";
  text += span_name(facts);
  if (!facts.box.empty) {
    text += "\nlowest        " + coordinates(facts.box.low, facts.precision);
    text += "\nhighest       " + coordinates(facts.box.high, facts.precision);
  }
  if (facts.spacing) {
    const Quartiles& q = *facts.spacing;
    text += "\nspacing       median " + json_number(q[2]) + ", half from " + json_number(q[1]) +
            " to " + json_number(q[3]) + ", all from " + json_number(q[0]) + " to " +
            json_number(q[4]);
  }
  for (const auto& [attribute, type] : facts.attributes) {
    text.append("\nattribute     ").append(attribute).append(" (").append(type).append(")");
  }
  return text + '\n';
}

std::string facts_json(const PointFacts& facts) {
  const std::string_view span = span_name(facts);
  JsonObject json;
  json.add("file", facts.file);
  json.add("format", facts.format);
  json.add("precision", facts.precision == Precision::kSingle ? "single" : "double");
  json.add("points", facts.points);
  json.add("invalid", facts.invalid);
  json.add("duplicates", facts.duplicates());
  json.add("distinct", facts.distinct);
  json.add("span", std::string(span.substr(span.find(' ') + 1)));
  json.add_raw("lowest", corner_json(facts, facts.box.low));
  json.add_raw("highest", corner_json(facts, facts.box.high));
  JsonObject spacing;
  for (std::size_t i = 0; facts.spacing && i < kQuartiles.size(); ++i) {
    spacing.add_raw(kQuartiles[i], json_number((*facts.spacing)[i]));
  }
  json.add_raw("spacing", facts.spacing ? spacing.text() : "null");
  JsonArray attributes;
  for (const auto& [attribute, type] : facts.attributes) {
    JsonObject one;
    one.add("name", attribute);
    one.add("type", std::string(type));
    attributes.add_raw(one.text());
  }
  json.add_raw("attributes", attributes.text());
  return json.text();
}

}  // namespace tetsculpt::cli
