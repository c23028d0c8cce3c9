// SPDX-License-Identifier: MIT
// Occlusion, roughness and metallic from files of their own -> one map.
#pragma once

#include <lichen/exemplar.h>

#include <span>
#include <vector>

namespace lichen::exemplar {

/// One map with the channels of all, in the order of MapChannel, as large as the largest: a bake
/// keeps what channels of one map have to do with one another exactly, and what maps have only in
/// the mean. The quantum is the finest. `wraps` as for resampled().
[[nodiscard]] MapExemplar joined(std::span<const MapExemplar> parts, bool wraps);

} // namespace lichen::exemplar
