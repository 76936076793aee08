#pragma once

#include <vector>

#include "io/ply_header.h"
#include "io/text_scanner.h"
#include "kernel/point.h"

namespace tetsculpt {

/// The vertices of an ascii body, one element per line; `in` stands on the last line of the
/// header. A coordinate of type float is rounded to one. Throws IoError with the line.
std::vector<Point3> parse_ply_ascii_body(const PlyHeader& header, TextScanner& in);

}  // namespace tetsculpt
