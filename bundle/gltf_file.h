// SPDX-License-Identifier: MIT
// The container of a glTF asset: GLB chunks or a .gltf text -> JSON document and buffers.
// Sources: glTF 2.0 specification, section 4 (GLB), 3.6 (buffers); RFC 4648 (base64).
#pragma once

#include "findings.h"

#include <nlohmann/json.hpp>

namespace lichen {

inline constexpr std::uint32_t kGlbMagic = 0x46546C67u;     // "glTF"
inline constexpr std::uint32_t kGlbChunkJson = 0x4E4F534Au; // "JSON"
inline constexpr std::uint32_t kGlbChunkBin = 0x004E4942u;  // "BIN"
inline constexpr std::size_t kGlbHeaderBytes = 12;
inline constexpr std::size_t kGlbChunkHeaderBytes = 8;

/// An asset whose JSON is syntactically sound and an object. Buffers are loaded when first asked
/// for, so that only those which hold tables are read.
class GltfFile {
public:
  /// `folder` is where files that buffers name are looked up; empty when there is none. Borrows
  /// `file`. Faults that leave nothing to read are recorded, and nothing is returned.
  [[nodiscard]] static std::optional<GltfFile>
  open(std::span<const std::byte> file, std::filesystem::path folder, FindingList& findings);

  [[nodiscard]] const nlohmann::json& document() const { return json_; }

  /// The bytes of a buffer view, in bounds. Faults are recorded once for each view or buffer.
  [[nodiscard]] std::optional<std::span<const std::byte>> bufferView(std::size_t index,
                                                                     FindingList& findings);
  /// Bytes of the buffers loaded so far.
  [[nodiscard]] std::size_t loadedBytes() const;

private:
  struct Buffer {
    bool loaded = false;
    bool usable = false;
    std::vector<std::byte> storage; ///< empty for the GLB chunk, which is borrowed
    std::span<const std::byte> bytes;
  };

  [[nodiscard]] bool splitGlb(std::span<const std::byte> file, FindingList& findings);
  [[nodiscard]] bool parseJson(FindingList& findings);
  const Buffer& buffer(std::size_t index, FindingList& findings);
  [[nodiscard]] bool loadBuffer(std::size_t index, Buffer& target, FindingList& findings);
  [[nodiscard]] std::string readUri(const std::string& uri, std::vector<std::byte>& bytes) const;

  std::filesystem::path folder_;
  std::span<const std::byte> text_;
  std::optional<std::span<const std::byte>> binaryChunk_;
  nlohmann::json json_;
  std::vector<Buffer> buffers_;
};

} // namespace lichen
