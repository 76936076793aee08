#include "io/attribute.h"

#include <cassert>
#include <utility>

namespace tetsculpt {

Attribute gathered(const Attribute& attribute, std::span<const std::uint32_t> from) {
  return std::visit(
      [&]<typename Value>(const std::vector<Value>& values) {
        std::vector<Value> taken;
        taken.reserve(from.size());
        for (const std::uint32_t i : from) {
          assert(i < values.size());
          taken.push_back(values[i]);
        }
        return Attribute{attribute.name, std::move(taken)};
      },
      attribute.values);
}

}  // namespace tetsculpt
