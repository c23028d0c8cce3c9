// SPDX-License-Identifier: MIT
// Reads the values of glTF accessors. Private to scene loading, which has validated the model.
#pragma once

#include <lichen/result.h>

#include <tiny_gltf.h>

#include <cstdint>
#include <vector>

namespace lichen::renderer {

/// The accessor's values as floats, with componentCount(type) components interleaved. Normalized
/// integers become [0, 1] or [-1, 1], sparse values are applied, and an accessor without a
/// bufferView is all zeros. Errors: badInput for NaN, infinity, or a sparse index outside the
/// accessor.
[[nodiscard]] Result<std::vector<float>> readAccessor(const tinygltf::Model& model, int accessor);

/// The values of an index accessor of 8, 16 or 32 bits. Errors: badInput for an index that is not
/// below `limit`, or a sparse index outside the accessor.
[[nodiscard]] Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model,
                                                             int accessor, std::size_t limit);

} // namespace lichen::renderer
