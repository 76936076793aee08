#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/attribute.h"

/// How the columns of points are called: coordinates x, y, z, and attributes as in io/attribute.h.
namespace tetsculpt {

/// The names, with those in which other programs mean the same replaced:
///   (1) x, y, z, red, green, blue, alpha, intensity, nx, ny, nz in any case, normal_x for nx;
///   (2) R, G, B, or Rf, Gf, Bf, in either case for red, green, blue if all three are there, and
///       then also A and I for alpha and intensity.
/// Other names stay as they are; a name that is empty becomes scalar_N, N its place from 1.
std::vector<std::string> canonical_names(std::vector<std::string> names);

/// x, y and z are among the names, each once.
bool name_coordinates(const std::vector<std::string>& names);

/// The name of part `part` of an attribute of several numbers: name_0, name_1, ...
std::string part_name(std::string_view name, std::size_t part);

/// Makes the names of attributes fit for any file: each is there once and none is x, y or z, by a
/// suffix _2, _3, ...; blanks and control characters become _.
void make_names_distinct(std::vector<Attribute>& attributes);

}  // namespace tetsculpt
