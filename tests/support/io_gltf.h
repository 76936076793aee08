#pragma once

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "io/byte_order.h"
#include "tests/support/io_json.h"

/// Reading glTF 2.0 assets as its specification says, apart from the writer.
namespace tetsculpt::testing {

struct Gltf {
  Json json;
  std::string buffer;
};

inline std::string from_base64(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  if (text.size() % 4 != 0) throw std::runtime_error("base64: no multiple of four");
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  while (text.ends_with('=')) text.remove_suffix(1);
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) throw std::runtime_error("base64: no digit");
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

inline Gltf gltf_of_text(const std::string& file) {
  Gltf asset{JsonParser(file).parse(), ""};
  if (!asset.json.has("buffers")) return asset;
  const std::string& uri = asset.json["buffers"][0]["uri"].text;
  const std::string head = "data:application/octet-stream;base64,";
  if (!uri.starts_with(head)) throw std::runtime_error("uri");
  asset.buffer = from_base64(std::string_view(uri).substr(head.size()));
  return asset;
}

inline Gltf gltf_of_binary(const std::string& file) {
  const auto word = [&](std::size_t at) {
    if (at + 4 > file.size()) throw std::runtime_error("cut off");
    return load_number<std::uint32_t>(file.data() + at, std::endian::little);
  };
  if (file.substr(0, 4) != "glTF" || word(4) != 2 || word(8) != file.size()) {
    throw std::runtime_error("head");
  }
  Gltf asset;
  std::vector<std::string> names;
  for (std::size_t at = 12; at < file.size();) {
    const std::size_t size = word(at);
    const std::string name = file.substr(at + 4, 4);
    if (size % 4 != 0 || at + 8 + size > file.size()) throw std::runtime_error("chunk");
    names.push_back(name);
    if (name == "JSON") {
      asset.json = JsonParser(file.substr(at + 8, size)).parse();
    } else {
      asset.buffer = file.substr(at + 8, size);
    }
    at += 8 + size;
  }
  const std::vector<std::string> both = {"JSON", std::string("BIN\0", 4)};
  if (names != both && names != std::vector<std::string>{"JSON"})
    throw std::runtime_error("chunks");
  return asset;
}

struct GltfNumbers {
  std::vector<std::vector<double>> elements;
  std::size_t type = 0;
  bool normalized = false;
};

/// The elements of an accessor. An exception if the format forbids what it says.
inline GltfNumbers elements_of(const Gltf& asset, std::size_t index) {
  const Json& accessor = asset.json["accessors"][index];
  const Json& view = asset.json["bufferViews"][accessor["bufferView"].size()];
  GltfNumbers result{{}, accessor["componentType"].size(), accessor.has("normalized")};
  const std::map<std::string, std::size_t> shapes = {{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
  const std::map<std::size_t, std::size_t> sizes = {{5120, 1}, {5121, 1}, {5122, 2},
                                                    {5123, 2}, {5125, 4}, {5126, 4}};
  const std::size_t components = shapes.at(accessor["type"].text);
  const std::size_t size = sizes.at(result.type);
  const std::size_t stride = view.has("byteStride") ? view["byteStride"].size() : components * size;
  const std::size_t offset = view["byteOffset"].size();
  const std::size_t end = offset + view["byteLength"].size();
  if (offset % 4 != 0 || stride % 4 != 0 || end > asset.buffer.size() ||
      offset + stride * accessor["count"].size() > end || accessor["count"].size() == 0 ||
      asset.buffer.size() != asset.json["buffers"][0]["byteLength"].size()) {
    throw std::runtime_error("layout");
  }
  const auto value = [&](const char* at) -> double {
    constexpr std::endian kOrder = std::endian::little;
    if (result.type == 5120) return load_number<std::int8_t>(at, kOrder);
    if (result.type == 5121) return load_number<std::uint8_t>(at, kOrder);
    if (result.type == 5122) return load_number<std::int16_t>(at, kOrder);
    if (result.type == 5123) return load_number<std::uint16_t>(at, kOrder);
    if (result.type == 5125) return load_number<std::uint32_t>(at, kOrder);
    return static_cast<double>(load_number<float>(at, kOrder));
  };
  for (std::size_t i = 0; i < accessor["count"].size(); ++i) {
    std::vector<double> element;
    for (std::size_t k = 0; k < components; ++k) {
      element.push_back(value(asset.buffer.data() + offset + i * stride + k * size));
    }
    result.elements.push_back(element);
  }
  return result;
}

}  // namespace tetsculpt::testing
