#pragma once

#include <optional>
#include <string_view>

#include "io/number_type.h"

namespace tetsculpt {

/// The type with this name in legacy VTK files, those of version 5.1 included.
std::optional<NumberType> vtk_type_named(std::string_view name);

}  // namespace tetsculpt
