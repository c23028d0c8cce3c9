// SPDX-License-Identifier: MIT
// The values of glTF accessors. Private to scene loading: the model has been validated.
#pragma once

#include <lichen/result.h>

#include <tiny_gltf.h>

#include <cstdint>
#include <vector>

namespace lichen::renderer {

/// The accessor's values as floats, componentCount(type) interleaved; normalized integers become
/// [0, 1] or [-1, 1], sparse values are applied, and all is 0 without a view. Errors: badInput for
/// NaN, Inf, or a sparse index outside the accessor.
[[nodiscard]] Result<std::vector<float>> readAccessor(const tinygltf::Model& model, int accessor);

/// The values of an accessor of indices, of 8, 16 or 32 bits, all of them below `limit`. Errors:
/// badInput for one that is not, or a sparse index outside the accessor.
[[nodiscard]] Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model,
                                                             int accessor, std::size_t limit);

} // namespace lichen::renderer
