// SPDX-License-Identifier: MIT
// Whether a glTF document keeps the rules that the loading code relies on.
#pragma once

#include "gltf_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lichen::renderer {

/// Checks types, indices, views inside their buffers, accessors inside their views, attribute types
/// and counts, the node forest, and extensionsRequired. What the document says about bytes is
/// checked against its own buffers' lengths; that the buffers have these lengths is for the loader.
/// Appends to `notes` what will be ignored. Errors: badInput with the JSON pointer of the place.
[[nodiscard]] Result<void> validateScene(const GltfFile& file, std::vector<std::string>& notes);

/// Bytes of one component (5120 to 5126), and components of a type such as "VEC3"; 0 when unknown.
[[nodiscard]] std::size_t componentBytes(std::uint64_t componentType);
[[nodiscard]] std::size_t componentCount(const std::string& type);

/// An accessor without a bufferView is zeros that take no room in the file: a bound on its claim.
inline constexpr std::uint64_t kMaxImplicitCount = std::uint64_t(1) << 24;

} // namespace lichen::renderer
