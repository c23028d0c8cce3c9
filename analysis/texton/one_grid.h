// SPDX-License-Identifier: MIT
// Gaussian models of exemplars of different sizes, brought to one grid of frequencies.
#pragma once

#include "fit.h"

#include <span>
#include <vector>

namespace lichen::texton {

/// The same textures, sampled at the texels of one tile: as wide as the widest model, and as high
/// as the highest at that width. Every exemplar spans the tile's width, as in a bundle, where the
/// number of its pixels says how fine it is and not how large. Their covariances are kept, and
/// where the shapes agree, all powers and cross-spectra; to a taller tile these are interpolated.
/// A model that has the size already is returned as it is. At least one; of one number of channels.
[[nodiscard]] std::vector<gaussian::GaussianModel>
onOneGrid(std::span<const gaussian::GaussianModel> models);

} // namespace lichen::texton
