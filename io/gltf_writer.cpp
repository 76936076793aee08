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
#include "io/gltf_codes.h"
#include "io/gltf_parts.h"
#include "io/io_error.h"

namespace tetsculpt {
namespace {

constexpr std::string_view kAsset = R"("asset":{"version":"2.0","generator":"tetsculpt"})";
constexpr std::size_t kVertexTarget = 34962;
constexpr std::size_t kIndexTarget = 34963;

std::string quoted(std::string_view text) {
  std::string result(1, '"');
  for (const char c : text) {
    if (c == '"' || c == '\\') result.push_back('\\');
    result.push_back(c);
  }
  result.push_back('"');
  return result;
}

std::string number(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

/// What stands in brackets in a JSON text.
class List {
 public:
  void add(std::string_view item) { text_.append(text_.empty() ? "" : ",").append(item); }
  void add(std::string_view name, std::string_view value) {
    add(quoted(name));
    text_.append(":").append(value);
  }
  void add(std::string_view name, std::size_t value) { add(name, std::to_string(value)); }
  const std::string& text() const { return text_; }
  std::string object() const { return std::string("{").append(text_).append("}"); }
  std::string array() const { return std::string("[").append(text_).append("]"); }

 private:
  std::string text_;
};

std::string accessor(const GltfPart& part, std::size_t index) {
  constexpr std::array<std::string_view, 4> kShapes = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  List members;
  members.add("bufferView", index);
  members.add("componentType", static_cast<std::size_t>(part.type));
  if (part.normalized) members.add("normalized", "true");
  members.add("count", part.count);
  members.add("type", quoted(kShapes[part.components - 1]));
  if (!part.bounds.empty()) members.add(part.bounds);
  return members.object();
}

std::string buffer_view(const GltfPart& part, std::size_t offset) {
  const bool indices = part.semantic.empty();
  List members;
  members.add("buffer", 0);
  members.add("byteOffset", offset);
  members.add("byteLength", part.size());
  if (!indices) members.add("byteStride", part.stride);
  members.add("target", indices ? kIndexTarget : kVertexTarget);
  return members.object();
}

std::size_t total_size(const std::vector<GltfPart>& parts) {
  std::size_t size = 0;
  for (const GltfPart& part : parts) size += part.size();
  return size;
}

std::string node(const Point3& origin) {
  List members;
  members.add("mesh", 0);
  if (origin != Point3{}) {
    List translation;
    for (const double value : {origin.x, origin.y, origin.z}) translation.add(number(value));
    members.add("translation", translation.array());
  }
  return members.object();
}

/// The one primitive of the one mesh.
std::string primitive(const std::vector<GltfPart>& parts) {
  List attributes;
  List members;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].semantic.empty()) {
      members.add("indices", k);
    } else {
      attributes.add(parts[k].semantic, k);
    }
  }
  if (members.text().empty()) members.add("mode", 0);  // points
  members.add("attributes", attributes.object());
  return members.object();
}

/// The members of the asset but its buffer.
List asset(const std::vector<GltfPart>& parts, const Point3& origin) {
  List accessors;
  List views;
  std::size_t offset = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    accessors.add(accessor(parts[k], k));
    views.add(buffer_view(parts[k], offset));
    offset += parts[k].size();
  }
  List members;
  members.add(kAsset);
  if (parts.empty()) return members;
  members.add(R"("scene":0,"scenes":[{"nodes":[0]}])");
  members.add("nodes", std::string("[").append(node(origin)).append("]"));
  members.add("meshes", std::string("[{\"primitives\":[").append(primitive(parts)).append("]}]"));
  members.add("accessors", accessors.array());
  members.add("bufferViews", views.array());
  return members;
}

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

void write_text(const std::vector<GltfPart>& parts, const List& members, AtomicFile& out) {
  out.write("{");
  out.write(members.text());
  if (!parts.empty()) {
    out.write(",\"buffers\":[{\"byteLength\":");
    out.write(std::to_string(total_size(parts)));
    out.write(",\"uri\":\"data:application/octet-stream;base64,");
    std::string pending;  // texts can be joined only at multiples of three bytes
    send(parts, [&](const std::string& bytes) {
      pending += bytes;
      const std::size_t whole = pending.size() / 3 * 3;
      out.write(base64(std::string_view(pending).substr(0, whole)));
      pending.erase(0, whole);
    });
    out.write(base64(pending));
    out.write("\"}]");
  }
  out.write("}");
}

void write_words(std::initializer_list<std::uint32_t> words, AtomicFile& out) {
  for (const std::uint32_t word : words) {
    std::array<char, sizeof word> bytes;
    store_little_endian(bytes.data(), word);
    out.write({bytes.data(), bytes.size()});
  }
}

void write_binary(const std::vector<GltfPart>& parts, List members, AtomicFile& out) {
  const std::size_t size = total_size(parts);
  if (!parts.empty()) {
    List buffer;
    buffer.add("byteLength", size);
    members.add("buffers", std::string("[").append(buffer.object()).append("]"));
  }
  std::string text = members.object();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t all = 12 + 8 + text.size() + (parts.empty() ? 0 : 8 + size);
  if (all > std::numeric_limits<std::uint32_t>::max()) {
    throw IoError(out.name(), "a .glb file cannot have 2^32 bytes");
  }
  write_words({kGlbMagic, kGlbVersion, static_cast<std::uint32_t>(all)}, out);
  write_words({static_cast<std::uint32_t>(text.size()), kGlbJson}, out);
  out.write(text);
  if (parts.empty()) return;
  write_words({static_cast<std::uint32_t>(size), kGlbBinary}, out);
  send(parts, [&](const std::string& bytes) { out.write(bytes); });
}

}  // namespace

WriteReport write_gltf(const TriangleMesh& mesh, std::span<const Attribute> attributes,
                       GltfContainer container, AtomicFile& out) {
  const Point3 origin = float_origin(mesh.points);
  if (const std::optional<std::size_t> i = beyond_floats(mesh.points, origin)) {
    throw IoError(out.name(),
                  "point " + std::to_string(*i) + " is too large for the floats of glTF");
  }
  WriteReport report{.rounded = rounded_axes(mesh.points, origin)};
  const std::vector<GltfPart> parts = gltf_parts(mesh, origin, attributes, report);
  if (container == GltfContainer::kBinary) {
    write_binary(parts, asset(parts, origin), out);
  } else {
    write_text(parts, asset(parts, origin), out);
  }
  return report;
}

}  // namespace tetsculpt
