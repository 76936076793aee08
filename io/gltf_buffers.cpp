// "glTF 2.0 Specification" (Khronos Group 2021), sections 3.6 (binary data storage) and 2.8 (URIs).
#include "io/gltf_buffers.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>
#include <utility>

#include "io/base64.h"
#include "io/io_error.h"
#include "io/quoted.h"

namespace tetsculpt {
namespace {

constexpr std::pair<std::string_view, std::size_t> kShapes[] = {
    {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};

/// Bytes of a number of this type; 0 if there is no such type.
std::size_t size_of(std::uint64_t type) {
  switch (static_cast<GltfType>(type)) {
    case GltfType::kInt8:
    case GltfType::kUint8:
      return 1;
    case GltfType::kInt16:
    case GltfType::kUint16:
      return 2;
    case GltfType::kUint32:
    case GltfType::kFloat32:
      return 4;
  }
  return 0;
}

/// With the bytes that %20 and the like stand for.
std::string percent_decoded(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const std::string_view digits = uri.substr(std::min(i + 1, uri.size()), 2);
    unsigned byte = 0;
    const char* const end = digits.data() + digits.size();
    if (uri[i] == '%' && digits.size() == 2 &&
        std::from_chars(digits.data(), end, byte, 16).ptr == end) {
      text += static_cast<char>(byte);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

bool has_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string_view::npos &&
         uri.substr(0, colon).find('/') == std::string_view::npos;
}

}  // namespace

GltfBuffers::GltfBuffers(const GltfJson& json)
    : json_(json), buffers_(json.list(json.root(), "buffers").size()) {}

GltfElements GltfBuffers::elements(const JsonValue& accessor) {
  const auto fail = [&](const std::string& reason) { json_.fail(accessor, "accessor: " + reason); };
  if (accessor.member("sparse") != nullptr) fail("sparse data is not read");
  const auto view_index = json_.integer_if_any(accessor, "bufferView");
  if (!view_index) fail("no bufferView; compressed data is not read");
  const std::uint64_t type = json_.integer(accessor, "componentType");
  const std::size_t size = size_of(type);
  if (size == 0) fail("unknown componentType " + std::to_string(type));
  const std::string& name = json_.text(accessor, "type");
  const auto* const shape = std::ranges::find(
      kShapes, name, [](const auto& known) { return std::string_view(known.first); });
  if (shape == std::end(kShapes)) fail("type " + tetsculpt::quoted(name) + " is not read");
  const JsonValue& view_of = json_.item("bufferViews", *view_index, accessor);
  const std::string_view bytes = view(view_of);
  const std::uint64_t element = size * shape->second;
  const std::uint64_t told = json_.integer_if_any(view_of, "byteStride").value_or(0);
  const std::uint64_t stride = told == 0 ? element : told;
  constexpr std::uint64_t kLongestStride = 252;
  if (stride < element || stride > std::max(kLongestStride, element)) {
    fail("elements of " + std::to_string(element) + " bytes, " + std::to_string(stride) + " apart");
  }
  const std::uint64_t offset = json_.integer_if_any(accessor, "byteOffset").value_or(0);
  const std::uint64_t count = json_.integer(accessor, "count");
  if (count == 0) fail("count is 0");
  if (offset > bytes.size() || element > bytes.size() - offset ||
      count - 1 > (bytes.size() - offset - element) / stride) {
    fail(std::to_string(count) + " elements from byte " + std::to_string(offset) +
         " of a bufferView of " + std::to_string(bytes.size()) + " bytes");
  }
  return {.first = bytes.data() + offset,
          .stride = static_cast<std::size_t>(stride),
          .count = static_cast<std::size_t>(count),
          .components = shape->second,
          .type = static_cast<GltfType>(type)};
}

std::string_view GltfBuffers::view(const JsonValue& buffer_view) {
  const std::string_view bytes = buffer(json_.integer(buffer_view, "buffer"), buffer_view);
  const std::uint64_t offset = json_.integer_if_any(buffer_view, "byteOffset").value_or(0);
  const std::uint64_t size = json_.integer(buffer_view, "byteLength");
  if (offset > bytes.size() || size > bytes.size() - offset) {
    json_.fail(buffer_view, "bufferView: " + std::to_string(size) + " bytes from byte " +
                                std::to_string(offset) + " of a buffer of " +
                                std::to_string(bytes.size()));
  }
  return bytes.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
}

std::string_view GltfBuffers::buffer(std::uint64_t index, const JsonValue& from) {
  const JsonValue& description = json_.item("buffers", index, from);
  Buffer& buffer = buffers_[static_cast<std::size_t>(index)];
  if (!buffer.bytes) {
    const std::string_view all = load(buffer, description, index == 0);
    const std::uint64_t size = json_.integer(description, "byteLength");
    if (size > all.size()) {
      json_.fail(description, "buffer: " + std::to_string(size) + " bytes announced, there are " +
                                  std::to_string(all.size()));
    }
    buffer.bytes = all.substr(0, static_cast<std::size_t>(size));
  }
  return *buffer.bytes;
}

std::string_view GltfBuffers::load(Buffer& to, const JsonValue& description, bool is_first) const {
  if (description.member("uri") == nullptr) {
    if (is_first && json_.binary()) return *json_.binary();
    json_.fail(description, "buffer: no uri, and no binary chunk");
  }
  const std::string& uri = json_.text(description, "uri");
  if (uri.starts_with("data:")) {
    constexpr std::string_view kMark = ";base64,";
    const std::size_t mark = uri.substr(0, uri.find(',') + 1).find(kMark);
    auto bytes = mark == std::string::npos
                     ? std::nullopt
                     : from_base64(std::string_view(uri).substr(mark + kMark.size()));
    if (!bytes) json_.fail(description, "buffer: its uri holds no base64 text");
    to.decoded = std::move(*bytes);
    return to.decoded;
  }
  if (has_scheme(uri))
    json_.fail(description, "buffer: " + tetsculpt::quoted(uri) + " is not a file");
  const std::filesystem::path file = json_.path().parent_path() / percent_decoded(uri);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    json_.fail(description, "buffer: there is no file " + tetsculpt::quoted(file.string()));
  }
  to.file = read_file(file);
  return to.file.view();
}

}  // namespace tetsculpt
