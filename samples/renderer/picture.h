// SPDX-License-Identifier: MIT
// Writes a finished picture to a file.
#pragma once

#include <lichen/image.h>
#include <lichen/result.h>

#include <filesystem>

namespace lichen::renderer {

/// .png: 8-bit sRGB with a dither of one code value, which prevents banding in the sky. .exr:
/// linear light. Errors as writeImage().
[[nodiscard]] Result<void> writePicture(const std::filesystem::path& path,
                                        const LinearImage& pixels);

} // namespace lichen::renderer
