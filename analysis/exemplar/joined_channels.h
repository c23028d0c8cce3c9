// SPDX-License-Identifier: MIT
// Occlusion, roughness and metallic from separate files -> one map.
#pragma once

#include <lichen/exemplar.h>

#include <span>
#include <vector>

namespace lichen::exemplar {

/// Returns one map with the channels of all parts, in the order of MapChannel, at the size of the
/// largest part. A bake preserves the relation between channels of one map exactly, but between
/// maps only on average. The quantum is the finest of the parts. `wraps` as for resampled().
[[nodiscard]] MapExemplar joined(std::span<const MapExemplar> parts, bool wraps);

} // namespace lichen::exemplar
