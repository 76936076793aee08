#include "io/gltf_writer.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/base64.h"
#include "io/byte_order.h"
#include "io/float_coordinates.h"
#include "io/gltf_parts.h"
#include "io/io_error.h"

namespace tetsculpt {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;  // "glTF"
constexpr std::uint32_t kJson = 0x4e4f534a;   // "JSON"
constexpr std::uint32_t kBin = 0x004e4942;    // "BIN"
constexpr int kVertexTarget = 34962;
constexpr int kIndexTarget = 34963;

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string member(std::string_view name, std::size_t value) {
  return quoted(name) + ":" + std::to_string(value);
}

std::string number(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

/// Text with commas between its items.
class List {
 public:
  void add(std::string_view item) { text_.append(text_.empty() ? "" : ",").append(item); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

std::string accessor(const GltfPart& part, std::size_t index) {
  constexpr std::array<std::string_view, 4> kShapes = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  std::string text = "{" + member("bufferView", index) + "," +
                     member("componentType", static_cast<std::size_t>(part.type));
  if (part.normalized) text += ",\"normalized\":true";
  text += "," + member("count", part.count) + ",\"type\":" + quoted(kShapes[part.components - 1]);
  if (!part.bounds.empty()) text += "," + part.bounds;
  return text + "}";
}

std::string buffer_view(const GltfPart& part, std::size_t offset) {
  const bool indices = part.semantic.empty();
  std::string text =
      "{\"buffer\":0," + member("byteOffset", offset) + "," + member("byteLength", part.size());
  if (!indices) text += "," + member("byteStride", part.stride);
  return text + "," + member("target", indices ? kIndexTarget : kVertexTarget) + "}";
}

std::size_t total_size(const std::vector<GltfPart>& parts) {
  std::size_t size = 0;
  for (const GltfPart& part : parts) size += part.size();
  return size;
}

std::string translation(const Point3& origin) {
  if (origin == Point3{}) return "";
  return ",\"translation\":[" + number(origin.x) + "," + number(origin.y) + "," + number(origin.z) +
         "]";
}

/// The JSON text up to the buffer's length; its uri, if it has one, and kEnd follow.
std::string json(const std::vector<GltfPart>& parts, const Point3& origin) {
  List attributes;
  List accessors;
  List views;
  std::size_t offset = 0;
  std::string primitive = "\"mode\":0";  // points, unless there are indices of triangles
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const GltfPart& part = parts[k];
    if (part.semantic.empty()) {
      primitive = member("indices", k);
    } else {
      attributes.add(member(part.semantic, k));
    }
    accessors.add(accessor(part, k));
    views.add(buffer_view(part, offset));
    offset += part.size();
  }
  return R"({"asset":{"version":"2.0","generator":"tetsculpt"},"scene":0,"scenes":[{"nodes":[0]}],)"
         R"("nodes":[{"mesh":0)" +
         translation(origin) + "}],\"meshes\":[{\"primitives\":[{\"attributes\":{" +
         attributes.text() + "}," + primitive + "}]}],\"accessors\":[" + accessors.text() +
         "],\"bufferViews\":[" + views.text() + "],\"buffers\":[{" + member("byteLength", offset);
}
constexpr std::string_view kEnd = "}]}";
constexpr std::string_view kEmptyAsset = R"({"asset":{"version":"2.0","generator":"tetsculpt"}})";

template <typename Sink>
void send(const std::vector<GltfPart>& parts, const Sink& sink) {
  std::string bytes;
  for (const GltfPart& part : parts) {
    in_pieces(part.count, [&](RowRange rows) {
      bytes.assign(rows.count * part.stride, 0);
      part.store(rows, bytes.data());
      sink(bytes);
    });
  }
}

void write_text(const std::vector<GltfPart>& parts, const std::string& head, AtomicFile& out) {
  out.write(head);
  out.write(",\"uri\":\"data:application/octet-stream;base64,");
  std::string pending;  // texts can be joined only at multiples of three bytes
  send(parts, [&](const std::string& bytes) {
    pending += bytes;
    const std::size_t whole = pending.size() / 3 * 3;
    out.write(base64(std::string_view(pending).substr(0, whole)));
    pending.erase(0, whole);
  });
  out.write(base64(pending));
  out.write("\"");
  out.write(kEnd);
}

void write_words(std::initializer_list<std::uint32_t> words, AtomicFile& out) {
  for (const std::uint32_t word : words) {
    std::array<char, sizeof word> bytes;
    store_little_endian(bytes.data(), word);
    out.write({bytes.data(), bytes.size()});
  }
}

void write_binary(const std::vector<GltfPart>& parts, std::string text, AtomicFile& out) {
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t size = total_size(parts);
  const std::size_t all = 12 + 8 + text.size() + (parts.empty() ? 0 : 8 + size);
  if (all > std::numeric_limits<std::uint32_t>::max()) {
    throw IoError(out.name(), "a .glb file cannot have 2^32 bytes");
  }
  write_words({kMagic, 2, static_cast<std::uint32_t>(all)}, out);
  write_words({static_cast<std::uint32_t>(text.size()), kJson}, out);
  out.write(text);
  if (parts.empty()) return;
  write_words({static_cast<std::uint32_t>(size), kBin}, out);
  send(parts, [&](const std::string& bytes) { out.write(bytes); });
}

}  // namespace

WriteReport write_gltf(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                       GltfContainer container, AtomicFile& out) {
  const bool binary = container == GltfContainer::kBinary;
  if (mesh.points.empty()) {
    if (binary) {
      write_binary({}, std::string(kEmptyAsset), out);
    } else {
      out.write(kEmptyAsset);
    }
    return {};
  }
  const Point3 origin = float_origin(mesh.points);
  if (const std::optional<std::size_t> i = beyond_floats(mesh.points, origin)) {
    throw IoError(out.name(),
                  "point " + std::to_string(*i) + " is too large for the floats of glTF");
  }
  WriteReport report{.rounded = rounded_axes(mesh.points, origin)};
  const std::vector<GltfPart> parts = gltf_parts(mesh, origin, attributes, report);
  const std::string head = json(parts, origin);
  if (binary) {
    write_binary(parts, head + std::string(kEnd), out);
  } else {
    write_text(parts, head, out);
  }
  return report;
}

}  // namespace tetsculpt
