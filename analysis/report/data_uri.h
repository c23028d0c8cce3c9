// SPDX-License-Identifier: MIT
// Pictures inside a page.
#pragma once

#include <lichen/image.h>
#include <lichen/json_tree.h>
#include <lichen/result.h>

namespace lichen {

/// {"png": the image as an 8-bit PNG in a data URI}. Errors as encodePng().
[[nodiscard]] Result<JsonTree> pictureJson(const SrgbImage& image);
[[nodiscard]] Result<JsonTree> pictureJson(const LinearImage& data);

} // namespace lichen
