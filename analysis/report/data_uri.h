// SPDX-License-Identifier: MIT
// Pictures inside a page.
#pragma once

#include <lichen/image.h>
#include <lichen/result.h>

#include <nlohmann/json_fwd.hpp>

namespace lichen {

/// {"png": the image as an 8-bit PNG in a data URI}. Errors as encodePng().
[[nodiscard]] Result<nlohmann::ordered_json> pictureJson(const SrgbImage& image);
[[nodiscard]] Result<nlohmann::ordered_json> pictureJson(const LinearImage& data);

} // namespace lichen
