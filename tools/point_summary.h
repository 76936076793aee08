#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "io/precision.h"
#include "kernel/box.h"
#include "kernel/point.h"
#include "sculpt/reconstruct.h"

/// What --dry-run says of points.
namespace tetsculpt::cli {

struct PointSummary {
  std::size_t count = 0;
  std::size_t distinct = 0;
  Span span = Span::kNothing;
  Box box = {};
};

/// Throws InvalidPoint and std::length_error, as reconstruct does.
PointSummary summary_of(std::span<const Point3> points);

/// For people, some lines. `skipped` more points are invalid; `precision` is that of the file.
std::string text_of(const PointSummary& points, const std::string& file, std::size_t skipped,
                    Precision precision);

}  // namespace tetsculpt::cli
