#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "io/attribute.h"

namespace tetsculpt::testing {

/// One attribute of each type, with three values: the least, the largest and one between.
inline std::vector<Attribute> attributes_of_every_type() {
  const auto values = []<typename Value>(Value between) {
    using Limits = std::numeric_limits<Value>;
    return std::vector<Value>{Limits::lowest(), Limits::max(), between};
  };
  return {{"a", values(std::int8_t{-1})},
          {"b", values(std::uint8_t{200})},
          {"c", values(std::int16_t{-2})},
          {"d", values(std::uint16_t{40000})},
          {"e", values(std::int32_t{-3})},
          {"f", values(std::uint32_t{3000000000})},
          {"g", values(-0.0F)},
          {"h", values(0.1)}};
}

/// red, green, blue and, if it is not empty, alpha, in this order.
template <typename Value>
std::vector<Attribute> colours(const std::vector<Value>& red, const std::vector<Value>& green,
                               const std::vector<Value>& blue,
                               const std::vector<Value>& alpha = {}) {
  std::vector<Attribute> all = {{"red", red}, {"green", green}, {"blue", blue}};
  if (!alpha.empty()) all.push_back({"alpha", alpha});
  return all;
}

}  // namespace tetsculpt::testing
