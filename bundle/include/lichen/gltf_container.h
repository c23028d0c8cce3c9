// SPDX-License-Identifier: MIT
// The container of a glTF asset: GLB chunks or .gltf text <-> JSON document and binary chunk, and
// the paths of external files. Users of this header must link nlohmann_json.
// Sources: glTF 2.0 specification, sections 4 (GLB) and 3.6.1 (URIs).
#pragma once

#include <lichen/bundle.h>

#include <nlohmann/json.hpp>

#include <variant>

namespace lichen {

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

/// Finding::code of a file that is not glTF.
inline constexpr const char* kNotGltf = "not-gltf";

/// Splits a .glb or .gltf into its parts and parses the JSON, or returns the fault. Limits: 64 MiB
/// of JSON, 4,194,304 values, 64 levels of nesting. The fault's code is "memory" when memory does
/// not suffice.
[[nodiscard]] std::variant<GltfContainer, Finding> openGltf(std::span<const std::byte> file);

/// Assembles a GLB from JSON text, a binary chunk, which may be empty, and complete further chunks.
/// The result must be below 4 GiB. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> frameGlb(std::string json, std::span<const std::byte> binary,
                                              std::span<const std::byte> otherChunks = {});

/// Decodes the %XX escapes of a relative URI to a path. Returns nothing for a URI with a scheme
/// (such as data:), a malformed escape or a NUL. Throws std::bad_alloc.
[[nodiscard]] std::optional<std::string> pathOfUri(const std::string& uri);

/// Resolves a relative path inside `folder`. Returns nothing if the path leaves the folder,
/// literally or through a symbolic link, or if `folder` is empty.
[[nodiscard]] std::optional<std::filesystem::path>
fileInside(const std::filesystem::path& folder, const std::filesystem::path& relative);

/// The folder of a file; "." for a bare file name.
[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& file);

} // namespace lichen
