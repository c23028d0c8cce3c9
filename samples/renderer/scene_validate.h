// SPDX-License-Identifier: MIT
// Checks that a glTF document satisfies the rules that the loading code relies on.
#pragma once

#include "gltf_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace lichen::renderer {

/// Checks types, indices, bufferViews against their buffers, accessors against their bufferViews,
/// attribute types and counts, the node hierarchy, and extensionsRequired. Byte ranges are checked
/// against the stated buffer lengths; the loader checks that the buffers have these lengths.
/// Appends a note to `notes` for everything that rendering ignores. Errors: badInput with the JSON
/// pointer.
[[nodiscard]] Result<void> validateScene(const GltfFile& file, std::vector<std::string>& notes);

/// Bytes of one component for a componentType from 5120 to 5126, and number of components of a type
/// such as "VEC3"; 0 when unknown.
[[nodiscard]] std::size_t componentBytes(std::uint64_t componentType);
[[nodiscard]] std::size_t componentCount(const std::string& type);

/// Maximum count of an accessor without a bufferView. Such an accessor is all zeros and takes no
/// bytes in the file, so only this bounds its memory.
inline constexpr std::uint64_t kMaxImplicitCount = std::uint64_t(1) << 24;

} // namespace lichen::renderer
