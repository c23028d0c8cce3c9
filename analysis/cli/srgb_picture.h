// SPDX-License-Identifier: MIT
// Pictures that are not maps of a material: painted spectra and patterns.
#pragma once

#include <lichen/image.h>
#include <lichen/image_io.h>
#include <lichen/result.h>

#include <filesystem>
#include <utility>
#include <variant>

namespace lichen::cli {

/// A picture as sRGB codes. Errors: as readImage().
[[nodiscard]] inline Result<SrgbImage> readSrgb(const std::filesystem::path& path) {
  Result<ImageFile> file = readImage(path);
  if (!file)
    return file.error();
  if (auto* image = std::get_if<SrgbImage>(&file.value().pixels))
    return std::move(*image);
  return toSrgb(std::get<LinearImage>(file.value().pixels));
}

} // namespace lichen::cli
