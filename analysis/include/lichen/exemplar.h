// SPDX-License-Identifier: MIT
// The input of a bake: the maps of a material.
#pragma once

#include <lichen/bundle.h>

#include <span>
#include <vector>

namespace lichen {

/// One map of an exemplar: `channels.size()` interleaved values per pixel, row 0 at the top, in
/// `encoding`. Value (x, y, c) is values[(y * width + x) * channels.size() + c].
struct MapExemplar {
  MapTarget target = MapTarget::baseColor;
  std::vector<MapChannel> channels; ///< [1, 3], in the order of the values
  ValueEncoding encoding = ValueEncoding::srgb;
  int width = 0;  ///< pixels, [1, 16384]
  int height = 0; ///< pixels, [1, 16384]
  /// width * height * channels.size() values. Nominal ranges: [0, 1] for srgb and linear, slopes in
  /// [-20, 20] for slope, log2(1 + x) for log2. Other values work as long as they and the
  /// quantities they encode lie in [-kHalfMax, kHalfMax], but 8-bit tables of srgb and linear maps
  /// clamp to [0, 1].
  std::vector<float> values;
  /// The step between adjacent stored values, in (0, 1]: 1/255 for an 8-bit file. Variation below
  /// its rounding error counts as none.
  double quantum = 1.0 / 255.0;
};

/// Whether the exemplar's opposite borders match.
enum class Periodic {
  detect, ///< measure every map; if one does not tile, blend the borders of all
  yes,
  no
};

/// Returns whether a bake treats these maps as periodic: what the option says, or for
/// Periodic::detect whether every map tiles. Each map must lie within the ranges above. Throws
/// std::bad_alloc, as all building blocks do.
[[nodiscard]] bool bordersFit(std::span<const MapExemplar> maps, Periodic periodic);

} // namespace lichen
