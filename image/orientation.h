// SPDX-License-Identifier: MIT
// Reads the camera's orientation from the EXIF block of a file.
#pragma once

#include <cstddef>
#include <span>

namespace lichen {

/// The orientation, 1 to 8, in IFD 0 of an EXIF block; 1 (upright) if there is none that is
/// readable. `block` starts with its TIFF header. Input may be hostile.
[[nodiscard]] int exifOrientation(std::span<const std::byte> block);

} // namespace lichen
