// SPDX-License-Identifier: MIT
// The extension's objects in a glTF document -> a bundle, with every fault recorded.
#pragma once

#include "gltf_file.h"
#include "object_reader.h"

namespace lichen {

/// Reads and checks the extension. The result may be used only when no error was recorded.
[[nodiscard]] Bundle readExtension(GltfFile& file, FindingList& findings);

/// Reads and checks one map; `tables` are those read so far, null where one could not be.
[[nodiscard]] NoiseMap readMap(ObjectReader& reader,
                               const std::vector<std::optional<Table>>& tables);

/// A bound that the schema states too; those of parameters are in bundle.h.
inline constexpr std::uint64_t kMaxTexCoord = 15;

} // namespace lichen
