// Any bytes are read as points, with as many values of each attribute, or refused with an IoError.
// TETSCULPT_FUZZ_FORMAT names the format; without it the content does.
#include "io/read_points.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>

#include "io/io_error.h"
#include "tests/fuzz/require.h"

namespace tetsculpt::fuzz {
namespace {

ReadPointsOptions options() {
  ReadPointsOptions result;
#ifdef TETSCULPT_FUZZ_FORMAT
  result.format = point_format_named(TETSCULPT_FUZZ_FORMAT);
  require(result.format.has_value(), "no such format");
#endif
  return result;
}

void run(std::string_view content) {
  try {
    const PointFile file = parse_points(content, "input", options());
    for (const Attribute& attribute : file.attributes) {
      const auto count =
          std::visit([](const auto& values) { return values.size(); }, attribute.values);
      require(count == file.points.size(), "an attribute without a value for each point");
    }
  } catch (const IoError&) {
  }
}

}  // namespace
}  // namespace tetsculpt::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tetsculpt::fuzz::run({reinterpret_cast<const char*>(data), size});
  return 0;
}
