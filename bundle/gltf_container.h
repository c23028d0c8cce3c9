// SPDX-License-Identifier: MIT
// The container of a glTF asset: GLB chunks or .gltf text -> JSON document and binary chunk.
// Source: glTF 2.0 specification, section 4.
#pragma once

#include <lichen/bundle.h>

#include <nlohmann/json.hpp>

#include <variant>

namespace lichen {

inline constexpr std::uint32_t kGlbMagic = 0x46546C67u;     // "glTF"
inline constexpr std::uint32_t kGlbChunkJson = 0x4E4F534Au; // "JSON"
inline constexpr std::uint32_t kGlbChunkBin = 0x004E4942u;  // "BIN"
inline constexpr std::uint32_t kGlbVersion = 2;
inline constexpr std::size_t kGlbHeaderBytes = 12;
inline constexpr std::size_t kGlbChunkHeaderBytes = 8;
inline constexpr std::size_t kGlbAlignment = 4; // of chunks

struct GltfContainer {
  GltfContainer() = default;
  GltfContainer(GltfContainer&&) noexcept = default;
  GltfContainer& operator=(GltfContainer&&) noexcept = default;
  ~GltfContainer(); ///< unlike the document's own destructor, does not allocate

  nlohmann::json document; ///< an object; asset.version is 2.x
  bool isGlb = false;
  std::span<const std::byte> text; ///< JSON text, borrowed from the file's bytes
  /// The binary chunk of a GLB, or nothing; also borrowed.
  std::optional<std::span<const std::byte>> binaryChunk;
  /// All further chunks of a GLB, with their headers and unknown content; also borrowed.
  std::span<const std::byte> otherChunks;
};

/// Splits a .glb or .gltf into its parts and parses the JSON, or returns the fault. The JSON may
/// have 64 MiB, 4,194,304 values and 64 levels of nesting. If memory runs out, the fault's code is
/// "memory".
[[nodiscard]] std::variant<GltfContainer, Finding> openGltf(std::span<const std::byte> file);

} // namespace lichen
