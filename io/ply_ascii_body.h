#pragma once

#include "io/ply_header.h"
#include "io/point_file.h"
#include "io/text_scanner.h"

namespace tetsculpt {

/// The vertices of an ascii body, one element per line, with their other scalars as attributes;
/// `in` stands on the last line of the header. A number of type float is rounded to one.
/// Throws IoError with the line, also if a number does not fit its type.
PointFile parse_ply_ascii_body(const PlyHeader& header, TextScanner& in);

}  // namespace tetsculpt
