// SPDX-License-Identifier: MIT
// How a camera was held: from the EXIF block of a file, and back to upright pixels.
#pragma once

#include <cstddef>
#include <span>

namespace lichen {

/// The orientation, 1 to 8, that IFD 0 of an EXIF block says; 1, which is upright, where it says
/// nothing that can be read. `block` begins with its TIFF header. Hostile bytes are expected.
[[nodiscard]] int exifOrientation(std::span<const std::byte> block);

} // namespace lichen
