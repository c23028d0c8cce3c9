// SPDX-License-Identifier: MIT
// Patches from random places of a picture, for patchDistance().
#pragma once

#include <lichen/image.h>

#include <cstdint>

namespace lichen::bench {

/// 96 x 96 patches of 9 x 9 pixels side by side, each from a random place in its own 96 x 96th of
/// the picture. patchDistance() takes exactly these. From a picture itself it takes patches at a
/// fixed spacing, which always meets what repeats at the same few places: it then finds a plain
/// repeat of denim farther from denim than any noise.
[[nodiscard]] SrgbImage patchSheet(const SrgbImage& image, std::uint32_t seed);

} // namespace lichen::bench
