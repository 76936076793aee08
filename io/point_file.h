#pragma once

#include <vector>

#include "io/attribute.h"
#include "io/point_format.h"
#include "io/precision.h"
#include "kernel/point.h"

namespace tetsculpt {

/// The points of a file in their order there.
struct PointFile {
  std::vector<Point3> points;
  /// kSingle if the file's own type of x, y and z is a 32-bit float; text has kDouble.
  Precision precision = Precision::kDouble;
  /// What the file says of each point besides its position, one value per point, in file order.
  std::vector<Attribute> attributes;
  /// What the file was read as, by whatever told it.
  PointFormat format = PointFormat::kText;
};

}  // namespace tetsculpt
