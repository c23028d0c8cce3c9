// SPDX-License-Identifier: MIT
// What a noise is baked from: the maps of a material.
#pragma once

#include <lichen/bundle.h>

#include <span>
#include <vector>

namespace lichen {

/// One map of an exemplar: `channels.size()` interleaved values a pixel, row 0 at the top, in the
/// encoding stated; value (x, y, c) is values[(y * width + x) * channels.size() + c].
struct MapExemplar {
  MapTarget target = MapTarget::baseColor;
  std::vector<MapChannel> channels; ///< [1, 3], in the order of the values
  ValueEncoding encoding = ValueEncoding::srgb;
  int width = 0;  ///< pixels, [1, 16384]
  int height = 0; ///< pixels, [1, 16384]
  /// width * height * channels.size(). Nominally in [0, 1] for srgb and linear, slopes of [-20, 20]
  /// for slope, log2(1 + x) for log2; others are baked too as long as they and what they stand for
  /// lie in [-kHalfMax, kHalfMax], but 8-bit tables of srgb and linear maps clamp to [0, 1].
  std::vector<float> values;
  /// The step between neighbouring stored values, (0, 1]: 1/255 of an 8-bit file. Variation below
  /// its rounding error counts as none.
  double quantum = 1.0 / 255.0;
};

/// Whether the exemplar's opposite borders fit together.
enum class Periodic {
  detect, ///< measured on every map; one that does not tile makes all of them be blended
  yes,
  no
};

/// Whether a bake of these maps keeps their borders: as the option says, or as all of them do.
/// Each map within the ranges above. Throws std::bad_alloc, as building blocks do.
[[nodiscard]] bool bordersFit(std::span<const MapExemplar> maps, Periodic periodic);

} // namespace lichen
