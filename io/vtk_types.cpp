#include "io/vtk_types.h"

#include <utility>

namespace tetsculpt {
namespace {

constexpr std::pair<std::string_view, NumberType> kTypes[] = {
    {"char", NumberType::kInt8},
    {"signed_char", NumberType::kInt8},
    {"unsigned_char", NumberType::kUint8},
    {"short", NumberType::kInt16},
    {"unsigned_short", NumberType::kUint16},
    {"int", NumberType::kInt32},
    {"unsigned_int", NumberType::kUint32},
    {"long", NumberType::kInt64},
    {"unsigned_long", NumberType::kUint64},
    {"vtktypeint64", NumberType::kInt64},
    {"vtktypeuint64", NumberType::kUint64},
    {"vtkIdType", NumberType::kInt32},
    {"float", NumberType::kFloat32},
    {"double", NumberType::kFloat64}};

}  // namespace

std::optional<NumberType> vtk_type_named(std::string_view name) {
  for (const auto& [known, type] : kTypes) {
    if (name == known) return type;
  }
  return std::nullopt;
}

}  // namespace tetsculpt
