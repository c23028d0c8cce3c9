// SPDX-License-Identifier: MIT
// The frame around a glTF scene: a .gltf's JSON, or a GLB's JSON chunk.
#pragma once

#include <lichen/result.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::renderer {

struct GltfFile {
  std::filesystem::path path;
  std::vector<std::byte> bytes; ///< the whole file
  bool binary = false;
  std::size_t binaryChunkSize = 0; ///< bytes of the BIN chunk; 0 when absent
  nlohmann::json json;             ///< an object
};

/// Reads the file and parses its JSON. Errors: badInput for a frame that does not fit the file,
/// JSON that cannot be parsed, or values nested deeper than kMaxJsonDepth.
[[nodiscard]] Result<GltfFile> readGltfFile(const std::filesystem::path& path);

/// A GLB of a JSON document whose only buffer, if it has one, is `binary`.
[[nodiscard]] std::vector<std::byte> makeGlb(const nlohmann::json& json,
                                             std::span<const std::byte> binary);

/// Deep enough for every exporter's `extras`; shallow enough for any parser's stack.
inline constexpr int kMaxJsonDepth = 64;

/// The file that a relative URI of a glTF file names, or nothing when the URI has a scheme, is
/// absolute, or leads out of the glTF file's folder.
[[nodiscard]] std::optional<std::filesystem::path> fileOfUri(const std::filesystem::path& gltfPath,
                                                             const std::string& decodedUri);

/// `text` on one line: control characters replaced, cut to `maxLength` bytes.
[[nodiscard]] std::string printable(const std::string& text, std::size_t maxLength = 60);

} // namespace lichen::renderer
