// SPDX-License-Identifier: MIT
// Pictures inside a page.
#pragma once

#include <lichen/image.h>
#include <lichen/result.h>

#include <string>

namespace lichen {

/// An image as an 8-bit PNG in a data URI. Errors as encodePng().
[[nodiscard]] Result<std::string> pngDataUri(const SrgbImage& image);
[[nodiscard]] Result<std::string> pngDataUri(const LinearImage& data);

} // namespace lichen
