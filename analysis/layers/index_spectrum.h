// SPDX-License-Identifier: MIT
// The spectrum of the Gaussian field behind an index map.
#pragma once

#include <lichen/spectrum_picture.h>

#include <cstdint>
#include <span>
#include <vector>

namespace lichen::layers {

/// Which pixels of a tile belong to a region, and which of these lie above the threshold.
struct IndexMap {
  int width = 0, height = 0;
  std::vector<float> region; ///< 0 or 1
  std::vector<float> above;  ///< 0 or 1; 0 outside the region
  [[nodiscard]] double proportion() const;
};

/// The correlation at lag (dx, dy) [pixels], at element (dy mod height) * width + (dx mod width),
/// of the standard normal field which, cut at the threshold of the proportion, has the map's
/// autocovariance. It falls to 0 towards lags of half the tile. Throws std::bad_alloc.
[[nodiscard]] std::vector<float> fieldCorrelation(const IndexMap& map);

/// The spectrum of that field as LayerSplit has it. Throws std::bad_alloc.
[[nodiscard]] SpectrumPicture indexSpectrum(const IndexMap& map);

} // namespace lichen::layers
