#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/file_content.h"
#include "io/gltf_codes.h"
#include "io/gltf_json.h"

namespace tetsculpt {

/// Where the elements of an accessor stand, little endian.
struct GltfElements {
  const char* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
  std::size_t components = 1;
  GltfType type = GltfType::kFloat32;
};

/// The buffers of a glTF asset: the binary chunk, texts of base64, or files beside it; read when
/// they are first needed. Refers to the asset, which must outlive it.
class GltfBuffers {
 public:
  explicit GltfBuffers(const GltfJson& json);

  /// The elements of an accessor; all are within their buffer, which lives as long as this.
  /// Throws IoError, also if they are sparse or compressed.
  GltfElements elements(const JsonValue& accessor);

 private:
  struct Buffer {
    std::string decoded;
    FileContent file;
    std::optional<std::string_view> bytes;
  };

  std::string_view view(const JsonValue& buffer_view);
  std::string_view buffer(std::uint64_t index, const JsonValue& from);
  std::string_view load(Buffer& to, const JsonValue& description, bool is_first) const;

  const GltfJson& json_;
  std::vector<Buffer> buffers_;
};

}  // namespace tetsculpt
