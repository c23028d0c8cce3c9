// SPDX-License-Identifier: MIT
// An image file's pixels -> the values of a map.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/image_io.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen::exemplar {

/// An image file and its name in notes and errors.
struct NamedImage {
  ImageFile file;
  std::string name; ///< "the image" if it is the only one, otherwise its file name
  std::string path;
};

/// Returns whether red, green and blue differ anywhere by more than a rounding step.
[[nodiscard]] bool hasColors(const NamedImage& image);

/// Returns red, green and blue for `target`, baseColor or emissive; grey becomes RGB. The codes of
/// PNG and JPEG do not change. EXR light is clamped to kHalfMax and encoded as sRGB, or as log2(1 +
/// light) if any value exceeds 1. Appends to `notes` what the user should know.
[[nodiscard]] MapExemplar colorMap(const NamedImage& image, MapTarget target,
                                   std::vector<std::string>& notes);

/// Returns the image's alpha, or nothing if it has none or is opaque everywhere.
[[nodiscard]] std::optional<MapExemplar> alphaMap(const NamedImage& image);

/// Returns channels of data in [0, 1], stored unchanged. `sources` are indices into the image's
/// red, green and blue, one for each of `channels`. A file that is not packed should be grey; if it
/// is not, a note says so. If any value exceeds 1, heights are encoded as log2(1 + value) and other
/// data is clamped, with a note. Error: badInput for an image without such a channel.
[[nodiscard]] Result<MapExemplar> dataMap(const NamedImage& image, MapTarget target,
                                          std::span<const MapChannel> channels,
                                          std::span<const int> sources, bool isPacked,
                                          std::vector<std::string>& notes);

/// Returns the slopes (-nx / nz, -ny / nz) of a normal map, with nz at least 0.05. Green points up
/// the image, or down if `greenPointsDown`. If the image was rotated upright, the slopes are
/// rotated with its pixels. Error: badInput for an image without three colours, or if most normals
/// point into the surface.
[[nodiscard]] Result<MapExemplar> normalMap(const NamedImage& image, bool greenPointsDown,
                                            std::vector<std::string>& notes);

/// Adds a note if the image's alpha is ignored although it is not opaque everywhere. If
/// `mayBeOpacity`, the note names the option that bakes alpha as opacity.
void noteIgnoredAlpha(const NamedImage& image, bool mayBeOpacity, std::vector<std::string>& notes);

} // namespace lichen::exemplar
