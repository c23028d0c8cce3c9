// SPDX-License-Identifier: MIT
// Accessors of a glTF asset -> numbers: strided, sparse, of any component type.
// Sources: glTF 2.0 specification, sections 3.6.2 and 5.1; KHR_mesh_quantization.
#pragma once

#include "gltf_file.h"

namespace lichen {

/// Of one accessor: three floats, or an index, take 12 bytes.
inline constexpr std::size_t kMostElements = std::size_t(1) << 25;

/// The extension that compresses a buffer view, of those that do, or nothing.
[[nodiscard]] std::optional<std::string> compressionOfView(const nlohmann::json& document,
                                                           std::size_t view);

/// The values of an accessor of 2 or 3 components; integers as numbers, normalized ones divided.
/// Finite. A fault is recorded, and nothing returned. Throws std::bad_alloc.
template <std::size_t kComponents>
[[nodiscard]] std::optional<std::vector<std::array<float, kComponents>>>
readVectors(GltfFile& file, std::size_t accessor, FindingList& findings);

/// The values of a scalar accessor of unsigned integers, all below `limit`.
[[nodiscard]] std::optional<std::vector<std::uint32_t>>
readIndices(GltfFile& file, std::size_t accessor, std::size_t limit, FindingList& findings);

} // namespace lichen
