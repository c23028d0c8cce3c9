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

/// A file, and what notes and errors call it.
struct NamedImage {
  ImageFile file;
  std::string name; ///< "the image" where there is no other, its file's name otherwise
  std::string path;
};

/// Whether red, green and blue differ somewhere by more than a rounding.
[[nodiscard]] bool hasColors(const NamedImage& image);

/// The red, green and blue of `target`, baseColor or emissive; grey becomes RGB. Codes of PNG and
/// JPEG stay, EXR light is encoded as sRGB, or as log2(1 + light) where it exceeds 1, clamped to
/// kHalfMax. `notes` gets a sentence for what the user should know.
[[nodiscard]] MapExemplar colorMap(const NamedImage& image, MapTarget target,
                                   std::vector<std::string>& notes);

/// The image's alpha; nothing when it has none or is opaque everywhere.
[[nodiscard]] std::optional<MapExemplar> alphaMap(const NamedImage& image);

/// Channels of data in [0, 1], stored as they are: of the image's red, green and blue those
/// numbered in `sources`, as `channels`; a file that is not packed should be grey, which a note
/// says where it is not. Above 1, heights are encoded as log2(1 + value) and others
/// clamped, with a note. Error: badInput for an image without such a channel.
[[nodiscard]] Result<MapExemplar> dataMap(const NamedImage& image, MapTarget target,
                                          std::span<const MapChannel> channels,
                                          std::span<const int> sources, bool isPacked,
                                          std::vector<std::string>& notes);

/// The slopes (-nx / nz, -ny / nz) of a normal map whose green points up the image, or, when
/// `greenPointsDown`, down; nz at least 0.05. Those of an image that was turned upright are turned
/// with its pixels. Error: badInput for an image without three colours, or most of whose normals
/// point into the surface.
[[nodiscard]] Result<MapExemplar> normalMap(const NamedImage& image, bool greenPointsDown,
                                            std::vector<std::string>& notes);

/// Says that alpha is ignored where it is not all opaque; and, of an image whose alpha may be baked
/// as opacity, how.
void noteIgnoredAlpha(const NamedImage& image, bool mayBeOpacity, std::vector<std::string>& notes);

} // namespace lichen::exemplar
