#pragma once

#include <cstdint>

/// Numbers that stand for things in glTF 2.0 files.
namespace tetsculpt {

/// Types of the components of an accessor.
enum class GltfType {
  kInt8 = 5120,
  kUint8 = 5121,
  kInt16 = 5122,
  kUint16 = 5123,
  kUint32 = 5125,
  kFloat32 = 5126,
};

inline constexpr std::uint32_t kGlbMagic = 0x46546c67;  ///< "glTF", at the begin of a .glb file
inline constexpr std::uint32_t kGlbVersion = 2;
inline constexpr std::uint32_t kGlbJson = 0x4e4f534a;    ///< "JSON", a kind of chunk
inline constexpr std::uint32_t kGlbBinary = 0x004e4942;  ///< "BIN", likewise

}  // namespace tetsculpt
