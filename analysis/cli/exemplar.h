// SPDX-License-Identifier: MIT
// From an image file to an exemplar that can be baked.
#pragma once

#include <lichen/image_io.h>
#include <lichen/tiling.h>

#include <string>
#include <vector>

namespace lichen::cli {

/// An image as a base-colour map: grey becomes RGB, alpha is dropped, EXR light is encoded as sRGB,
/// or as log2(1 + light) where it exceeds 1, clamped to kHalfMax. `notes` gets a sentence for what
/// the user should know.
[[nodiscard]] MapExemplar baseColorExemplar(const ImageFile& file, std::vector<std::string>& notes);

} // namespace lichen::cli
