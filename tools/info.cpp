#include "tools/info.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "io/extension.h"
#include "io/io_error.h"
#include "io/read_points.h"
#include "kernel/box.h"
#include "kernel/distinct_points.h"
#include "kernel/first_simplex.h"
#include "kernel/nearest_distances.h"
#include "tools/arguments.h"
#include "tools/file_words.h"
#include "tools/json.h"
#include "tools/messages.h"

namespace tetsculpt::cli {
namespace {

std::string info_help() {
  return R"(Usage: tetsculpt info [OPTIONS] POINTS

Describes a file of points: how many, what they span and how densely they lie,
and what else the file says of each.

  POINTS    )" +
         point_format_extensions() + R"(

Options:
  --json        print one JSON object (--stats means the same)
  -h, --help    this text

Exit status:
  0  done
  1  wrong usage
  2  the file is unreadable or broken, or its coordinates are too far apart
  5  standard output could not be written
)";
}

constexpr std::array<std::string_view, 5> kSpans = {"nothing", "a point", "a line", "a plane",
                                                    "a solid"};
constexpr std::array<std::string_view, 8> kTypes = {"int8",  "uint8",  "int16", "uint16",
                                                    "int32", "uint32", "float", "double"};
static_assert(std::variant_size_v<AttributeValues> == kTypes.size());

/// The least, the quartiles and the largest.
using Quartiles = std::array<double, 5>;
constexpr std::array<std::string_view, 5> kQuartiles = {"least", "quarter", "median",
                                                        "three_quarters", "largest"};

struct Facts {
  std::string file;
  std::string format;
  Precision precision = Precision::kDouble;
  std::size_t points = 0;
  std::size_t invalid = 0;
  std::size_t distinct = 0;
  Box box;  ///< of the valid points
  std::string_view span;
  std::optional<Quartiles> spacing;  ///< distances of the distinct points to their nearest others
  std::vector<std::pair<std::string, std::string_view>> attributes;  ///< names and types
};

/// The extension where it names the format of the file, or else a name of it.
std::string format_of(const PointFile& file, const std::filesystem::path& path) {
  if (point_format_of(path) == file.format) return lowercase_extension(path).substr(1);
  return std::string(point_format_name(file.format));
}

/// Each is one of the values; the lower one if it falls between two.
Quartiles quartiles(std::vector<double> values) {
  std::ranges::sort(values);
  Quartiles result{};
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = values[(values.size() - 1) * i / 4];
  return result;
}

Facts describe(const std::filesystem::path& path) {
  PointFile file = read_points(path);
  Facts facts;
  facts.file = path.string();
  facts.format = format_of(file, path);
  facts.precision = file.precision;
  facts.points = file.points.size();
  for (const Attribute& attribute : file.attributes) {
    facts.attributes.emplace_back(attribute.name, kTypes[attribute.values.index()]);
  }
  facts.invalid = std::erase_if(file.points, [](const Point3& p) { return !finite(p); });
  for (const Point3& p : file.points) facts.box.include(p);
  const DistinctPoints distinct = distinct_points(file.points);
  facts.distinct = distinct.points.size();
  facts.span = kSpans[static_cast<std::size_t>(first_simplex(distinct.points).size)];
  if (facts.distinct < 2) return facts;
  facts.spacing = quartiles(nearest_distances(distinct.points));
  for (double& x : *facts.spacing) x = std::ldexp(x, -distinct.scale_exponent);
  return facts;
}

std::size_t duplicates(const Facts& facts) { return facts.points - facts.invalid - facts.distinct; }

std::string_view name(Precision precision) {
  return precision == Precision::kSingle ? "32-bit floats" : "64-bit floats";
}

std::string coordinates(const Point3& p, std::string_view between) {
  return json_number(p.x)
      .append(between)
      .append(json_number(p.y))
      .append(between)
      .append(json_number(p.z));
}

std::string text(const Facts& facts) {
  std::string text = facts.file + ": " + counted(facts.points, "point");
  text += "\nformat        " + facts.format + ", coordinates as ";
  text += name(facts.precision);
  text += "\ninvalid       " + std::to_string(facts.invalid);
  text += "\nduplicates    " + std::to_string(duplicates(facts));
  text += "\nspan          ";
  text += facts.span;
  if (!facts.box.empty) {
    text += "\nlowest        " + coordinates(facts.box.low, " ");
    text += "\nhighest       " + coordinates(facts.box.high, " ");
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

std::string json(const Facts& facts) {
  JsonObject json;
  json.add("file", facts.file);
  json.add("format", facts.format);
  json.add("precision", facts.precision == Precision::kSingle ? "single" : "double");
  json.add("points", facts.points);
  json.add("invalid", facts.invalid);
  json.add("duplicates", duplicates(facts));
  json.add("distinct", facts.distinct);
  json.add("span", std::string(facts.span.substr(facts.span.find(' ') + 1)));
  const auto corner = [&](const Point3& p) {
    return facts.box.empty ? "null" : '[' + coordinates(p, ", ") + ']';
  };
  json.add_raw("lowest", corner(facts.box.low));
  json.add_raw("highest", corner(facts.box.high));
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

}  // namespace

int info(std::span<const char* const> words) {
  FileWords parsed;
  Facts facts;
  try {
    parsed = parse_file_words(words, {.noun = "point"});
    if (parsed.help) return print(info_help());
    facts = describe(parsed.file);
  } catch (const UsageError& error) {
    return fail(kUsage, std::string(error.what()) + " ('tetsculpt info --help' explains)");
  } catch (const IoError& error) {
    return fail(kBadInput, error.what());
  } catch (const InvalidPoint& error) {
    return fail(kBadInput, parsed.file.string() + ": " + error.what() +
                               " (points count from 0, without invalid ones)");
  } catch (const std::length_error& error) {
    return fail(kBadInput, parsed.file.string() + ": " + error.what());
  }
  return print(parsed.json ? json(facts) + '\n' : text(facts));
}

}  // namespace tetsculpt::cli
