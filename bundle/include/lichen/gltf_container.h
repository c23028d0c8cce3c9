// SPDX-License-Identifier: MIT
// The container of a glTF asset: GLB chunks or a .gltf text <-> JSON document and binary chunk, and
// the files beside it. What includes this links nlohmann_json.
// Sources: glTF 2.0 specification, section 4 (GLB), 3.6.1 (URIs).
#pragma once

#include <lichen/bundle.h>

#include <nlohmann/json.hpp>

#include <variant>

namespace lichen {

struct GltfContainer {
  GltfContainer() = default;
  GltfContainer(GltfContainer&&) noexcept = default;
  GltfContainer& operator=(GltfContainer&&) noexcept = default;
  ~GltfContainer(); ///< allocates nothing, unlike the document's own destructor

  nlohmann::json document; ///< an object; asset.version is 2.x
  bool isGlb = false;
  std::span<const std::byte> text; ///< of the document, borrowed from the file's bytes
  /// Of a GLB that has one; borrowed too.
  std::optional<std::span<const std::byte>> binaryChunk;
  /// The chunks of a GLB behind those two, with their headers: nobody knows what they hold.
  std::span<const std::byte> otherChunks;
};

/// The code of the fault of a file that is no glTF at all.
inline constexpr const char* kNotGltf = "not-gltf";

/// Takes the frame off a .glb or .gltf and parses its JSON, up to 64 MiB and 4,194,304 values of
/// it, 64 levels deep; or says what is wrong. The fault's code is "memory" when memory did not
/// suffice.
[[nodiscard]] std::variant<GltfContainer, Finding> openGltf(std::span<const std::byte> file);

/// A GLB of a JSON text, a binary chunk, which may be empty, and whole chunks behind it. Below
/// 4 GiB. Throws std::bad_alloc.
[[nodiscard]] std::vector<std::byte> frameGlb(std::string json, std::span<const std::byte> binary,
                                              std::span<const std::byte> otherChunks = {});

/// The relative path that a URI stands for, its %XX undone; nothing for a URI with a scheme, such
/// as one of data, a malformed escape or a NUL. Throws std::bad_alloc.
[[nodiscard]] std::optional<std::string> pathOfUri(const std::string& uri);

/// The file that a relative path names, or nothing when it lies outside the folder, by its words or
/// through a link. `folder` empty: nothing lies inside it.
[[nodiscard]] std::optional<std::filesystem::path>
fileInside(const std::filesystem::path& folder, const std::filesystem::path& relative);

/// The folder of a file, "." for a bare name.
[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& file);

} // namespace lichen
