// SPDX-License-Identifier: MIT
// A finished picture into a file.
#pragma once

#include <lichen/image.h>
#include <lichen/result.h>

#include <filesystem>

namespace lichen::renderer {

/// .png: sRGB code of 8 bits with a dither of one code value, so that a sky has no bands; .exr:
/// light. Errors as writeImage().
[[nodiscard]] Result<void> writePicture(const std::filesystem::path& path,
                                        const LinearImage& pixels);

} // namespace lichen::renderer
