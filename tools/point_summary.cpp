#include "tools/point_summary.h"

#include <charconv>

#include "kernel/distinct_points.h"
#include "kernel/first_simplex.h"

namespace tetsculpt::cli {
namespace {

/// The fewest digits that tell it from other numbers of the file's precision.
std::string shortest(double value, Precision precision) {
  char digits[64];
  char* const end = digits + sizeof digits;
  return {digits, precision == Precision::kSingle
                      ? std::to_chars(digits, end, static_cast<float>(value)).ptr
                      : std::to_chars(digits, end, value).ptr};
}

}  // namespace

PointSummary summary_of(std::span<const Point3> points) {
  const DistinctPoints distinct = distinct_points(points);
  PointSummary out{.count = points.size(), .distinct = distinct.points.size()};
  out.span = static_cast<Span>(first_simplex(distinct.points).size);
  for (const Point3& p : points) out.box.include(p);
  return out;
}

std::string text_of(const PointSummary& points, const std::string& file, std::size_t skipped,
                    Precision precision) {
  const auto& [low, high, empty] = points.box;
  const auto axis = [&](const char* name, double from, double to) {
    return std::string("  ") + name + " from " + shortest(from, precision) + " to " +
           shortest(to, precision) + '\n';
  };
  return file + ": " + std::to_string(points.count + skipped) + " points\n  " +
         std::to_string(points.distinct) + " distinct, " +
         std::to_string(points.count - points.distinct) + " duplicates, " +
         std::to_string(skipped) + " invalid\n" + axis("x", low.x, high.x) +
         axis("y", low.y, high.y) + axis("z", low.z, high.z);
}

}  // namespace tetsculpt::cli
