// "glTF 2.0 Specification" (Khronos Group 2021), sections 3.2 (assets) and 4.4 (GLB files).
#include "io/gltf_json.h"

#include <algorithm>
#include <bit>

#include "io/byte_order.h"
#include "io/gltf_codes.h"
#include "io/io_error.h"
#include "io/line_of.h"
#include "io/quoted.h"

namespace tetsculpt {
namespace {

constexpr std::size_t kHeadSize = 12;  // magic, version, length
constexpr std::size_t kChunkHead = 8;  // length, kind
constexpr std::string_view kMagic = "glTF";

/// Extensions that an asset may require without that its triangles are other ones.
constexpr std::array<std::string_view, 5> kHarmless = {"KHR_materials_", "KHR_texture_",
                                                       "EXT_texture_", "KHR_lights_", "KHR_xmp"};

std::uint32_t word(std::string_view content, std::size_t at) {
  return load_number<std::uint32_t>(content.data() + at, std::endian::little);
}

}  // namespace

GltfJson::GltfJson(std::string_view content, const std::filesystem::path& path)
    : path_(path), text_(content) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (content.starts_with(kMagic)) {
    take_chunks(content);
  } else if (content.starts_with(kByteOrderMark)) {
    text_.remove_prefix(kByteOrderMark.size());
  }
  try {
    root_ = parse_json(text_);
  } catch (const JsonError& error) {
    fail(error.offset(), error.what());
  }
  check_asset();
}

void GltfJson::take_chunks(std::string_view content) {
  const auto fail_at = [this](std::size_t at, const std::string& reason) {
    throw IoError(path_, ByteOffset{at}, reason);
  };
  if (content.size() < kHeadSize + kChunkHead) fail_at(content.size(), "the file ends in its head");
  if (word(content, 4) != kGlbVersion) {
    fail_at(4, "version " + std::to_string(word(content, 4)) + " of glTF; 2 is read");
  }
  const std::size_t end = word(content, 8);
  if (end > content.size()) {
    fail_at(8, std::to_string(end) + " bytes announced, the file has " +
                   std::to_string(content.size()));
  }
  for (std::size_t at = kHeadSize, chunk = 0; at + kChunkHead <= end; ++chunk) {
    const std::size_t size = word(content, at);
    const std::uint32_t kind = word(content, at + 4);
    if (size > end - at - kChunkHead) fail_at(at, "a chunk that ends behind the end of the file");
    const std::string_view bytes = content.substr(at + kChunkHead, size);
    if (chunk == 0 && kind != kGlbJson) fail_at(at + 4, "the first chunk is not JSON");
    if (chunk == 0) {
      text_ = bytes;
      text_at_ = at + kChunkHead;
    } else if (chunk == 1 && kind == kGlbBinary) {
      binary_ = bytes;
    }
    at += kChunkHead + size;
  }
  if (!text_at_) fail_at(kHeadSize, "no room for a chunk");
}

void GltfJson::check_asset() const {
  const JsonValue* const asset = root_.member("asset");
  if (asset == nullptr) fail(root_, "not a glTF file: no asset");
  const std::string& version = text(*asset, "version");
  if (!version.starts_with("2."))
    fail(*asset, "version " + tetsculpt::quoted(version) + " of glTF; 2 is read");
  for (const JsonValue& extension : list(root_, "extensionsRequired")) {
    const auto* const name = extension.as<std::string>();
    if (name == nullptr) fail(extension, "the name of an extension must be a text");
    if (std::ranges::any_of(kHarmless, [&](auto begin) { return name->starts_with(begin); })) {
      continue;
    }
    fail(extension,
         "the file requires the extension " + tetsculpt::quoted(*name) + ", which is not read");
  }
}

std::uint64_t GltfJson::integer(const JsonValue& value) const {
  constexpr double kEnd = 9007199254740992;  // 2^53: integers below are doubles
  const auto* const number = value.as<double>();
  if (number == nullptr || !(*number >= 0 && *number < kEnd) ||
      static_cast<double>(static_cast<std::uint64_t>(*number)) != *number) {
    fail(value, "expected a whole number, not negative");
  }
  return static_cast<std::uint64_t>(*number);
}

std::optional<std::uint64_t> GltfJson::integer_if_any(const JsonValue& object,
                                                      std::string_view name) const {
  const JsonValue* const value = object.member(name);
  if (value == nullptr) return std::nullopt;
  return integer(*value);
}

std::uint64_t GltfJson::integer(const JsonValue& object, std::string_view name) const {
  const auto value = integer_if_any(object, name);
  if (!value) fail(object, std::string("no ").append(name));
  return *value;
}

const std::string& GltfJson::text(const JsonValue& object, std::string_view name) const {
  const JsonValue* const value = object.member(name);
  if (value == nullptr) fail(object, std::string("no ").append(name));
  const auto* const text = value->as<std::string>();
  if (text == nullptr) fail(*value, std::string(name).append(" must be a text"));
  return *text;
}

std::span<const JsonValue> GltfJson::list(const JsonValue& object, std::string_view name) const {
  const JsonValue* const value = object.member(name);
  if (value == nullptr) return {};
  const auto* const items = value->as<JsonValue::List>();
  if (items == nullptr) fail(*value, std::string(name).append(" must be a list"));
  return *items;
}

std::span<const double> GltfJson::numbers(const JsonValue& object, std::string_view name,
                                          std::span<double> to) const {
  const JsonValue* const value = object.member(name);
  if (value == nullptr) return {};
  const std::span<const JsonValue> items = list(object, name);
  for (std::size_t i = 0; i < items.size() && i < to.size(); ++i) {
    const auto* const number = items[i].as<double>();
    if (number == nullptr) fail(items[i], std::string(name).append(" needs numbers"));
    to[i] = *number;
  }
  if (items.size() != to.size()) {
    fail(*value, std::string(name) + " has " + std::to_string(items.size()) + " numbers, not " +
                     std::to_string(to.size()));
  }
  return to;
}

const JsonValue& GltfJson::item(std::string_view list_name, std::uint64_t index,
                                const JsonValue& from) const {
  const std::span<const JsonValue> items = list(root_, list_name);
  if (index >= items.size()) {
    fail(from, "index " + std::to_string(index) + " into " + std::string(list_name) +
                   ", of which " + "there are " + std::to_string(items.size()));
  }
  return items[static_cast<std::size_t>(index)];
}

void GltfJson::fail(const JsonValue& at, std::string_view reason) const { fail(at.offset, reason); }

void GltfJson::fail(std::size_t offset, std::string_view reason) const {
  if (text_at_) throw IoError(path_, ByteOffset{*text_at_ + offset}, reason);
  throw IoError(path_, LineNumber{line_of(text_, offset)}, reason);
}

}  // namespace tetsculpt
