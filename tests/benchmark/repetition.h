// SPDX-License-Identifier: MIT
// How much a result repeats its exemplar as a whole, and how much the exemplar repeats by itself.
#pragma once

#include <lichen/image.h>

namespace lichen::bench {

/// The highest correlation of the luminance with itself, moved by at least `leastPixels` in any
/// direction and by at most half of a side along both axes. 1 for a plain repeat whose period is in
/// that range.
[[nodiscard]] double repetition(const SrgbImage& result, double leastPixels);

/// The same of a plain repeat of the exemplar. All moves count that are at least `leastPixels` away
/// from the whole repeats.
[[nodiscard]] double repetitionOfPlainRepeat(const SrgbImage& exemplar, double leastPixels);

} // namespace lichen::bench
