// SPDX-License-Identifier: MIT
// How far each pixel lies from the other labels.
#pragma once

#include <lichen/layers.h>

#include <vector>

namespace lichen::layers {

/// The distance from the centre of each pixel of `label` to the centre of the nearest pixel of
/// another label [pixels], and 0 for other labels. Infinite if there are none. Throws
/// std::bad_alloc.
[[nodiscard]] std::vector<float> distanceToOthers(const LabelImage& labels, int label);

} // namespace lichen::layers
